// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/conformity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/conformity_text.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/plates.h"
#include "axiometry/report/figures/parts/scale.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using iso230_2::Judgement;
using plot::label;
using plot::Operations;
using uncertainty::Verdict;
namespace ink = plot::ink;

constexpr double bar_left = 34.0;
constexpr double bar_right = 352.0;
constexpr double text_left = 362.0;
constexpr double judgement_pitch = 25.0;
constexpr double zone_height = 13.0;
constexpr double scale_height = 30.0;
constexpr double legend_height = 18.0;
constexpr double disc_radius = 2.3;
constexpr double interval_cap_half_height = 3.0;
constexpr double narrowest_interval = 2.0 * disc_radius + 1.0;  // a shorter one would hide behind the disc
constexpr double fractions_least = 1.25;                        // of the tolerance that the scale shows
constexpr double fractions_most = 2.0;

constexpr Colour accept_fill = ink::faint(ink::blue, 0.16);
constexpr Colour reject_fill = ink::faint(ink::vermilion, 0.34);

struct Rectangle {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  bool empty() const { return right - left < 0.05; }
};

enum class Zone { accepted, undecided, rejected };

/// Lines at 45° within the rectangle, which a grey print keeps.
void draw_hatch(Operations& operations, const Rectangle& r) {
  constexpr double pitch = 3.2;
  const double height = r.bottom - r.top;
  for (double foot = r.left - height + pitch; foot < r.right; foot += pitch) {
    const double from = std::max(foot, r.left);
    const double to = std::min(foot + height, r.right);
    if (to - from < 0.05) continue;
    operations.push_back(
        plot::line({from, r.bottom - (from - foot)}, {to, r.bottom - (to - foot)}, ink::solid(ink::grey, 0.35)));
  }
}

void draw_zone(Operations& operations, const Rectangle& r, Zone zone) {
  if (r.empty()) return;
  if (zone == Zone::undecided) return draw_hatch(operations, r);
  operations.push_back(Path{.points = {{r.left, r.top}, {r.right, r.top}, {r.right, r.bottom}, {r.left, r.bottom}},
                            .closed = true,
                            .stroke = ink::solid(ink::none, 0.0),
                            .fill = zone == Zone::accepted ? accept_fill : reject_fill});
}

/// A parameter in parts of its tolerance.
struct Bar {
  const Judgement& judgement;
  double value = 0.0;
  std::optional<uncertainty::Interval> interval;  ///< interval of the uncertainty of record
  std::optional<double> accepted_to;              ///< below 0 where nothing is accepted; absent when not known
  std::optional<double> rejected_from;            ///< absent likewise
};

/// Of the magnitude: an interval of a signed parameter that holds zero begins there.
uncertainty::Interval folded(const uncertainty::Interval& interval) {
  const double low = std::abs(interval.lower);
  const double high = std::abs(interval.upper);
  const bool holds_zero = interval.lower < 0.0 && interval.upper > 0.0;
  return {holds_zero ? 0.0 : std::min(low, high), std::max(low, high)};
}

Bar bar_of(const Judgement& judgement) {
  const double limit = judgement.tolerance.limit.in_native();
  Bar bar{judgement, judgement.magnitude->in_native() / limit, {}, {}, {}};
  if (judgement.uncertainty) {
    const bool is_signed = iso230_2::may_be_below_0(judgement.tolerance.parameter->key);
    const uncertainty::Interval& stated = judgement.uncertainty->interval;
    const uncertainty::Interval shown =
        is_signed ? folded(stated) : uncertainty::Interval{std::max(stated.lower, 0.0), stated.upper};
    bar.interval = uncertainty::Interval{shown.lower / limit, shown.upper / limit};
  }
  if (judgement.has_guard_band()) {
    bar.accepted_to = 1.0 - judgement.decision.guard_band / limit;
    bar.rejected_from = 1.0 + judgement.decision.rejection_band / limit;
  }
  return bar;
}

double fractions_shown(const std::vector<Bar>& bars) {
  constexpr double margin = 0.06;
  double most = fractions_least;
  for (const Bar& bar : bars)
    most = std::max(most,
                    std::max(bar.interval ? bar.interval->upper : bar.value, bar.rejected_from.value_or(1.0)) + margin);
  return std::min(most, fractions_most);
}

constexpr double arrow_length = 6.0;

/// A filled head at the right end of a bar: what is meant lies further on.
Path arrow_at_end(double y, double tip = bar_right) {
  constexpr double half_width = 2.6;
  return {.points = {{tip, y}, {tip - arrow_length, y - half_width}, {tip - arrow_length, y + half_width}},
          .closed = true,
          .stroke = ink::solid(ink::black, 0.0),
          .fill = ink::black};
}

void draw_zones(Operations& operations, const Bar& bar, const plot::Scale& x, double y) {
  const double top = y - zone_height / 2.0;
  const double bottom = y + zone_height / 2.0;
  const auto at = [&](double fraction) { return x(std::clamp(fraction, 0.0, x.value_high)); };
  const double accept_end = bar.accepted_to ? at(*bar.accepted_to) : bar_left;
  const double reject_begin = bar.rejected_from ? at(*bar.rejected_from) : bar_right;
  draw_zone(operations, {bar_left, top, accept_end, bottom}, Zone::accepted);
  draw_zone(operations, {accept_end, top, reject_begin, bottom}, Zone::undecided);
  draw_zone(operations, {reject_begin, top, bar_right, bottom}, Zone::rejected);
  operations.push_back(Path{.points = {{bar_left, top}, {bar_right, top}, {bar_right, bottom}, {bar_left, bottom}},
                            .closed = true,
                            .stroke = ink::solid(ink::grey, 0.4),
                            .fill = ink::none});
}

/// The interval of record, cut at zero and at the end of the scale, and the value on it: a disc, or two heads in place
/// of the one of the interval when it lies beyond the scale itself.
void draw_value(Operations& operations, const Bar& bar, const plot::Scale& x, double y) {
  const bool beyond = bar.value > x.value_high;
  if (bar.interval) {
    const auto& [low, high] = *bar.interval;
    const double from = x(std::min(low, x.value_high));
    const double to = x(std::min(high, x.value_high));
    const auto cap = [&](double at) {
      operations.push_back(plot::line({at, y - interval_cap_half_height}, {at, y + interval_cap_half_height},
                                      ink::solid(ink::black, 0.9)));
    };
    if (to - from > narrowest_interval) {
      operations.push_back(plot::line({from, y}, {to, y}, ink::solid(ink::black, 0.9)));
      if (low > 0.0) cap(from);
      if (high <= x.value_high) cap(to);
    }
    if (high > x.value_high && !beyond) operations.push_back(arrow_at_end(y));
  }
  if (beyond) {
    operations.push_back(arrow_at_end(y));
    operations.push_back(arrow_at_end(y, bar_right - arrow_length));
    return;
  }
  operations.push_back(Disc{
      .centre = {x(bar.value), y}, .radius = disc_radius, .fill = ink::black, .stroke = ink::solid(ink::white, 0.5)});
}

/// "9.6 ± 4.3 of 10 µm", "9.6 (8.0 to 12.3) of 10 µm", in English
std::string value_text(const Judgement& judgement, const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const ShownParameter shown = show(judgement, subject.assessment, kind, options);
  const double limit = judgement.tolerance.limit.in_native() * parameter_scale(kind, options.unit).per_native;
  const std::string doubt = !shown.U.empty()          ? " ± " + shown.U
                            : !shown.interval.empty() ? fmt::format(" ({})", shown.interval)
                                                      : "";
  return fmt::format("{}{} of {}\u00a0{}", shown.value, doubt, shown_short(limit, options), shown.unit);
}

void draw_row(Operations& operations, const Bar& bar, const plot::Scale& x, double y, const Subject& subject,
              const Options& options) {
  const Judgement& judgement = bar.judgement;
  draw_value(operations, bar, x, y);
  plot::Runs symbol = plot::symbol(*judgement.tolerance.parameter);
  operations.push_back(label(std::move(symbol), {bar_left - 6.0, y + 2.6}, ink::text_size, Anchor::end));
  constexpr double room = plot::plate_width - text_left;
  operations.push_back(label({plot::plain(plot::shortened(translated(value_text(judgement, subject, options), options),
                                                          room, ink::text_size))},
                             {text_left, y - 1.2}, ink::text_size, Anchor::start));
  TextRun verdict = plot::plain(translated(uncertainty::verdict_name(judgement.decision.verdict), options));
  verdict.bold = true;
  operations.push_back(label({std::move(verdict)}, {text_left, y + 8.3}, ink::text_size, Anchor::start));
}

/// Per cent of the tolerance along the foot, and the limit through all rows.
void draw_scale(Operations& operations, const plot::Scale& x, double top, double bottom, const Options& options) {
  const double tick_length = 3.0;
  const plot::Ticks ticks = plot::divide(0.0, 100.0 * x.value_high, 7.0, plot::Division::decimal);
  for (double percent : ticks.major) {
    const double at = x(percent / 100.0);
    operations.push_back(plot::line({at, bottom}, {at, bottom + tick_length}, ink::solid(ink::grey, 0.5)));
    Text number = label({plot::plain(plot::tick_label(percent, ticks.decimals, options.numbers))},
                        {at, bottom + tick_length + 7.5}, ink::tick_text_size, Anchor::middle);
    operations.push_back(std::move(number));
  }
  operations.push_back(plot::line({bar_left, bottom}, {bar_right, bottom}, ink::solid(ink::grey, 0.5)));
  operations.push_back(label(translated({plot::plain("Magnitude / % of the tolerance "), plot::italic("T")}, options),
                             {(bar_left + bar_right) / 2.0, bottom + 24.0}, ink::text_size, Anchor::middle));
  operations.push_back(plot::line({x(1.0), top}, {x(1.0), bottom}, ink::solid(ink::black, 1.1)));
}

/// What the zones and signs mean, in one row.
class Legend {
 public:
  Legend(Operations& operations, double base_line, const Options& options)
      : operations_(operations), options_(options), y_(base_line) {}

  void zone(Zone zone, std::string_view text) {
    const Rectangle sample{x_, y_ - 6.4, x_ + sample_width, y_ + 1.4};
    draw_zone(operations_, sample, zone);
    operations_.push_back(Path{.points = {{sample.left, sample.top},
                                          {sample.right, sample.top},
                                          {sample.right, sample.bottom},
                                          {sample.left, sample.bottom}},
                               .closed = true,
                               .stroke = ink::solid(ink::grey, 0.4),
                               .fill = ink::none});
    name({plot::plain(text)});
  }

  /// With the interval where there is one, and its method.
  void value(std::optional<iso230_2::UncertaintyMethod> method) {
    const double middle = y_ - 2.5;
    if (method) {
      operations_.push_back(plot::line({x_, middle}, {x_ + sample_width, middle}, ink::solid(ink::black, 0.9)));
      for (double at : {x_, x_ + sample_width})
        operations_.push_back(plot::line({at, middle - interval_cap_half_height},
                                         {at, middle + interval_cap_half_height}, ink::solid(ink::black, 0.9)));
    }
    operations_.push_back(Disc{.centre = {x_ + sample_width / 2.0, middle},
                               .radius = disc_radius,
                               .fill = ink::black,
                               .stroke = ink::solid(ink::white, 0.5)});
    if (method == iso230_2::UncertaintyMethod::monte_carlo) {
      name({plot::plain("value and interval (Monte Carlo)")});
    } else if (method) {
      name({plot::plain("value ± "), plot::italic("U"),
            plot::plain(fmt::format(" ({})", iso230_2::method_title(*method)))});
    } else {
      name({plot::plain("value")});
    }
  }

  void limit() {
    const double middle = x_ + sample_width / 2.0;
    operations_.push_back(plot::line({middle, y_ - 7.0}, {middle, y_ + 2.0}, ink::solid(ink::black, 1.1)));
    name({plot::plain("tolerance "), plot::italic("T")});
  }

 private:
  static constexpr double sample_width = 16.0;

  void name(const plot::Runs& english) {
    plot::Runs runs = translated(english, options_);
    const double width = text_width(runs, ink::text_size);
    operations_.push_back(label(std::move(runs), {x_ + sample_width + 4.0, y_}, ink::text_size, Anchor::start));
    x_ += sample_width + 4.0 + width + 14.0;
  }

  Operations& operations_;
  const Options& options_;
  double y_;
  double x_ = bar_left;
};

/// All rest on one.
std::optional<iso230_2::UncertaintyMethod> method_of(const std::vector<Bar>& bars) {
  for (const Bar& bar : bars)
    if (bar.judgement.uncertainty) return bar.judgement.uncertainty->method;
  return std::nullopt;
}

void draw_legend(Operations& operations, const std::vector<Bar>& bars, double base_line, const Options& options) {
  Legend legend(operations, base_line, options);
  const auto undecided_possible = [](const Bar& bar) {
    return !bar.accepted_to || *bar.accepted_to < *bar.rejected_from;
  };
  const bool any_band = std::ranges::any_of(bars, [](const Bar& bar) { return bar.accepted_to.has_value(); });
  if (any_band) legend.zone(Zone::accepted, "conforms");
  if (std::ranges::any_of(bars, undecided_possible)) legend.zone(Zone::undecided, "undecided");
  if (any_band) legend.zone(Zone::rejected, "does not conform");
  legend.limit();
  legend.value(method_of(bars));
}

std::string description(const std::vector<Bar>& bars, const Subject& subject, const Options& options) {
  std::string text = "Each parameter against its tolerance:";
  for (const Bar& bar : bars)
    text += fmt::format("{} {} = {}, {}", &bar == &bars.front() ? "" : ";", bar.judgement.tolerance.parameter->symbol,
                        value_text(bar.judgement, subject, options),
                        uncertainty::verdict_name(bar.judgement.decision.verdict));
  return text + ".";
}

}  // namespace

std::optional<Figure> conformity_figure(const Subject& subject, const Options& asked) {
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  std::vector<Bar> bars;
  for (const Judgement& judgement : subject.judgements)
    if (judgement.magnitude) bars.push_back(bar_of(judgement));
  if (bars.empty()) return std::nullopt;
  Figure figure{.width = plot::plate_width, .height = 0.0, .title = {}, .description = {}, .operations = {}};
  const double header = plot::draw_label(figure.operations, translated(subject.assessment.label, options), bar_left,
                                         plot::plate_width - bar_left);
  draw_legend(figure.operations, bars, header + 9.0, options);
  const double top = header + legend_height;
  const double bottom = top + judgement_pitch * static_cast<double>(bars.size());
  const plot::Scale x{0.0, fractions_shown(bars), bar_left, bar_right};
  for (std::size_t k = 0; k < bars.size(); ++k)
    draw_zones(figure.operations, bars[k], x, top + judgement_pitch * (static_cast<double>(k) + 0.5));
  draw_scale(figure.operations, x, top, bottom, options);
  for (std::size_t k = 0; k < bars.size(); ++k)
    draw_row(figure.operations, bars[k], x, top + judgement_pitch * (static_cast<double>(k) + 0.5), subject, options);
  figure.height = bottom + scale_height;
  const AxisKind kind = subject.test.metadata.axis.kind;
  figure.title = fmt::format("Conformity of {} to its tolerances. Rule: {}", plot::axis_phrase(subject),
                             rule_title(bars.front().judgement.rule, kind, options));
  figure.description = description(bars, subject, options);
  return figure;
}

}  // namespace axiometry::report
