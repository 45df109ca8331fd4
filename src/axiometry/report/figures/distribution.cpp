// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/plates.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/figures/parts/scale.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using iso230_2::ParameterDistribution;
using plot::label;
using plot::Operations;
using plot::Range;
namespace ink = plot::ink;

constexpr std::size_t columns = 3;
constexpr double panel_margin = 9.0;  // room for half a tick label
constexpr double panel_gap = 20.0;
constexpr double panel_width = (plot::plate_width - 2.0 * panel_margin - 2.0 * panel_gap) / 3.0;
constexpr double title_height = 13.0;
constexpr double bracket_row = 5.0;
constexpr double plot_height = 46.0;
constexpr double panel_axis_height = 14.0;
constexpr double row_gap = 10.0;
constexpr double panel_tick_length = 2.5;
constexpr double bracket_cap_half_height = 2.0;

constexpr Colour histogram_fill = ink::faint(ink::blue, 0.25);
const Stroke outline = ink::solid(ink::blue, 0.6);
const Stroke value_line = ink::solid(ink::black, 1.1);
const Stroke mean_line{.colour = ink::blue, .width = 0.9, .dashes = {3.0, 1.8}};
const Stroke limit_line{.colour = ink::vermilion, .width = 1.1, .dashes = {6.0, 1.8, 1.0, 1.8}};
const Stroke interval_line = ink::solid(ink::blue, 1.4);
const Stroke annex_a_line = ink::solid(ink::grey, 0.9);
const Stroke gum_line{.colour = ink::black, .width = 0.8, .dashes = {1.6, 1.2}};

/// Rows of families, so that the grid is read across and down; what does not exist closes up.
constexpr std::string_view order[] = {"A", "A_up", "A_down", "E", "E_up", "E_down",
                                      "R", "R_up", "R_down", "M", "B",    "B_mean"};

struct Bracket {
  double low = 0.0;
  double high = 0.0;
  const Stroke* stroke = nullptr;
};

struct Panel {
  const iso230_2::ParameterInfo* parameter = nullptr;
  const ParameterDistribution* distribution = nullptr;
  std::vector<Bracket> brackets;  ///< the interval that is stated; value ± U of other methods
  std::vector<double> limits;     ///< of B̄ on both sides

  const uncertainty::OutputSummary& summary() const { return distribution->summary; }
  double value() const { return distribution->value; }
};

Panel panel_of(const iso230_2::ParameterInfo& parameter, const ParameterDistribution& distribution,
               const Subject& subject) {
  Panel panel{&parameter, &distribution, {}, {}};
  const auto& assessment = subject.assessment;
  const double value = distribution.value;
  panel.brackets.push_back({std::min(distribution.low, value), std::max(distribution.high, value), &interval_line});
  const auto about_value = [&](Deviation U, const Stroke& stroke) {
    panel.brackets.push_back({value - U.in_native(), value + U.in_native(), &stroke});
  };
  if (const auto U = assessment.annex_a ? assessment.annex_a->U.*parameter.member : std::nullopt)
    about_value(*U, annex_a_line);
  if (const auto* gum = assessment.gum ? assessment.gum->find(parameter.key) : nullptr)
    about_value(gum->uncertainty.U, gum_line);
  for (const auto& judgement : subject.judgements) {
    if (judgement.tolerance.parameter != &parameter) continue;
    const double limit = judgement.tolerance.limit.in_native();
    panel.limits.push_back(limit);
    if (iso230_2::may_be_below_0(parameter.key)) panel.limits.push_back(-limit);
  }
  return panel;
}

std::vector<Panel> panels_of(const Subject& subject) {
  std::vector<Panel> panels;
  for (std::string_view key : order) {
    const auto& parameter = *iso230_2::find_parameter(key);
    const auto index = static_cast<std::size_t>(&parameter - iso230_2::parameters);
    const auto& distribution = subject.assessment.monte_carlo->distributions[index];
    if (distribution && distribution->refusal.empty()) panels.push_back(panel_of(parameter, *distribution, subject));
  }
  return panels;
}

/// Too narrow to be drawn with a width.
bool is_constant(const uncertainty::Histogram& histogram) {
  const double width = histogram.width * static_cast<double>(histogram.counts.size());
  return width <= 1e-9 * std::abs(histogram.lower);
}

/// Histogram and value always; brackets and limits up to the width of these on each side, so that they cannot squeeze
/// the histogram to nothing.
Range range_of(const Panel& panel, const Options& options) {
  const auto& histogram = panel.summary().histogram;
  Range range{histogram.lower, histogram.lower + histogram.width * static_cast<double>(histogram.counts.size())};
  range.see(panel.value());
  range.see(panel.distribution->low);
  range.see(panel.distribution->high);
  const bool flat = range.size() <= 1e-9 * std::max(std::abs(range.low), std::abs(range.high));
  const double place = std::pow(10.0, -*options.deviation_decimals);
  const double reach = flat ? std::max(0.2 * std::abs(panel.value()), place) : range.size();
  const Range most{range.low - reach, range.high + reach};
  if (flat) range = {range.low - reach / 2.0, range.high + reach / 2.0};
  for (const Bracket& bracket : panel.brackets) {
    range.see(std::max(bracket.low, most.low));
    range.see(std::min(bracket.high, most.high));
  }
  for (double limit : panel.limits)
    if (most.has(limit)) range.see(limit);
  const double margin = 0.04 * range.size();
  return {range.low - margin, range.high + margin};
}

/// Where one histogram stands on paper.
struct Place {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;  ///< edges of the plot
  plot::Scale x;                                            ///< scale of native values
};

/// The outline between two values, closed along the foot.
Path area(const uncertainty::Histogram& histogram, double from, double to, double per_count, const Place& place,
          Colour colour) {
  Path path{
      .points = {{place.x(from), place.bottom}}, .closed = true, .stroke = ink::solid(ink::none, 0.0), .fill = colour};
  for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
    const double left = histogram.lower + histogram.width * static_cast<double>(k);
    const double right = left + histogram.width;
    if (right <= from || left >= to) continue;
    const double y = place.bottom - per_count * static_cast<double>(histogram.counts[k]);
    path.points.push_back({place.x(std::max(left, from)), y});
    path.points.push_back({place.x(std::min(right, to)), y});
  }
  path.points.push_back({place.x(to), place.bottom});
  return path;
}

void draw_histogram(Operations& operations, const Panel& panel, const Place& place) {
  const auto& histogram = panel.summary().histogram;
  if (is_constant(histogram)) {
    const double x = place.x(panel.summary().mean);
    operations.push_back(plot::line({x, place.top}, {x, place.bottom}, ink::solid(histogram_fill, 4.0)));
    return;
  }
  const auto highest = static_cast<double>(*std::ranges::max_element(histogram.counts));
  const double per_count = 0.96 * (place.bottom - place.top) / std::max(highest, 1.0);
  const double end = histogram.lower + histogram.width * static_cast<double>(histogram.counts.size());
  operations.push_back(area(histogram, histogram.lower, end, per_count, place, histogram_fill));
  Path whole = area(histogram, histogram.lower, end, per_count, place, ink::none);
  whole.closed = false;
  whole.stroke = outline;
  operations.push_back(std::move(whole));
}

/// A bracket that goes on beyond the panel ends in a head there.
void draw_bracket_end(Operations& operations, double value, const Place& place, double y, const Stroke& stroke) {
  constexpr double head_length = 3.6;
  constexpr double head_half_width = 1.7;
  const double x = place.x(value);
  if (x >= place.left && x <= place.right) {
    operations.push_back(plot::line({x, y - bracket_cap_half_height}, {x, y + bracket_cap_half_height},
                                    ink::solid(stroke.colour, stroke.width)));
    return;
  }
  const double tip = x < place.left ? place.left : place.right;
  const double base = tip + (x < place.left ? head_length : -head_length);
  operations.push_back(Path{.points = {{tip, y}, {base, y - head_half_width}, {base, y + head_half_width}},
                            .closed = true,
                            .stroke = ink::solid(ink::none, 0.0),
                            .fill = stroke.colour});
}

void draw_brackets(Operations& operations, const Panel& panel, const Place& place, double first_row) {
  for (std::size_t k = 0; k < panel.brackets.size(); ++k) {
    const auto& [low, high, stroke] = panel.brackets[k];
    const double y = first_row + bracket_row * static_cast<double>(k);
    operations.push_back(
        plot::line({std::max(place.x(low), place.left), y}, {std::min(place.x(high), place.right), y}, *stroke));
    for (double end : {low, high}) draw_bracket_end(operations, end, place, y, *stroke);
  }
}

/// As many as leave room between their labels; at least the fewest there are.
plot::Ticks ticks_for(const Range& shown, NumberStyle style) {
  constexpr double label_gap = 8.0;
  for (double wanted = 5.0; wanted > 1.0; wanted -= 1.0) {
    plot::Ticks ticks = plot::divide(shown.low, shown.high, wanted, plot::Division::decimal);
    const double pitch =
        ticks.major.size() < 2 ? panel_width : panel_width * (ticks.major[1] - ticks.major[0]) / shown.size();
    if (plot::widest_label(ticks, style) + label_gap <= pitch) return ticks;
  }
  return plot::divide(shown.low, shown.high, 1.0, plot::Division::decimal);
}

void draw_axis(Operations& operations, const Place& place, const plot::AxisUnit& unit, const Options& options) {
  operations.push_back(
      plot::line({place.left, place.bottom}, {place.right, place.bottom}, ink::solid(ink::black, 0.6)));
  const Range shown{place.x.value_low / unit.native, place.x.value_high / unit.native};
  const plot::Ticks ticks = ticks_for(shown, options.numbers);
  double taken = -1.0;
  for (double tick : ticks.major) {
    const double x = place.x(tick * unit.native);
    operations.push_back(
        plot::line({x, place.bottom}, {x, place.bottom + panel_tick_length}, ink::solid(ink::black, 0.6)));
    plot::Runs runs = {plot::plain(plot::tick_label(tick, ticks.decimals, options.numbers))};
    const double half = text_width(runs, ink::tick_text_size) / 2.0;
    const double middle = std::clamp(x, half + 0.5, plot::plate_width - half - 0.5);
    if (middle - half < taken || half > panel_width / 2.0) continue;
    taken = middle + half + 2.0;
    operations.push_back(
        label(std::move(runs), {middle, place.bottom + panel_tick_length + 7.5}, ink::tick_text_size, Anchor::middle));
  }
}

/// "A = 9.6 µm" and, on the right, the limit.
void draw_title(Operations& operations, const Panel& panel, const Place& place, double base_line,
                const Subject& subject, const Options& options) {
  const std::string value = plot::shown_value(panel.parameter->member, subject, options);
  plot::Runs title = plot::symbol(*panel.parameter);
  for (TextRun& run : title) run.bold = true;
  const double symbol_width = 1.1 * text_width(title, ink::text_size);
  title.push_back(plot::plain(plot::shortened(value, panel_width - symbol_width, ink::text_size)));
  const double taken = symbol_width + text_width({title.back()}, ink::text_size);
  operations.push_back(label(std::move(title), {place.left, base_line}, ink::text_size, Anchor::start));
  std::string remark;
  if (is_constant(panel.summary().histogram)) remark = "does not vary";
  if (!panel.limits.empty()) {
    const AxisKind kind = subject.test.metadata.axis.kind;
    const ParameterScale scale = parameter_scale(kind, options.unit);
    remark = fmt::format("limit {}", shown_short(panel.limits.front() * scale.per_native, options));
  }
  plot::Runs runs = {plot::plain(translated(remark, options))};
  if (remark.empty() || taken + 6.0 + text_width(runs, ink::tick_text_size) > panel_width) return;
  operations.push_back(label(std::move(runs), {place.right, base_line}, ink::tick_text_size, Anchor::end,
                             panel.limits.empty() ? ink::grey : ink::vermilion));
}

void draw_panel(Operations& operations, const Panel& panel, Point corner, double brackets_height,
                const plot::AxisUnit& unit, const Subject& subject, const Options& options) {
  const Range range = range_of(panel, options);
  const double top = corner.y + title_height + brackets_height;
  const Place place{corner.x,
                    corner.x + panel_width,
                    top,
                    top + plot_height,
                    {range.low, range.high, corner.x, corner.x + panel_width}};
  draw_histogram(operations, panel, place);
  draw_axis(operations, place, unit, options);
  const auto upright = [&](double value, const Stroke& stroke) {
    if (range.has(value))
      operations.push_back(plot::line({place.x(value), place.top - 1.0}, {place.x(value), place.bottom}, stroke));
  };
  for (double limit : panel.limits) upright(limit, limit_line);
  upright(panel.summary().mean, mean_line);
  upright(panel.value(), value_line);
  draw_brackets(operations, panel, place, corner.y + title_height);
  draw_title(operations, panel, place, corner.y + 8.0, subject, options);
}

std::vector<plot::LegendEntry> legend_of(const std::vector<Panel>& panels, const Subject& subject,
                                         const Options& options) {
  const auto& assessment = subject.assessment;
  const auto entry = [&](const Stroke& stroke, std::string_view text) {
    return plot::LegendEntry{stroke, {}, {}, {plot::plain(translated(text, options))}};
  };
  const std::string interval = shown_percent(assessment.monte_carlo->coverage, options) + " interval";
  std::vector<plot::LegendEntry> entries = {entry(value_line, "measured"), entry(mean_line, "mean of the distribution"),
                                            entry(interval_line, interval)};
  if (assessment.annex_a)
    entries.push_back({annex_a_line, {}, {}, translated({plot::plain("Annex A, ± "), plot::italic("U")}, options)});
  if (assessment.gum)
    entries.push_back({gum_line, {}, {}, translated({plot::plain("GUM, ± "), plot::italic("U")}, options)});
  if (std::ranges::any_of(panels, [](const Panel& panel) { return !panel.limits.empty(); }))
    entries.push_back(entry(limit_line, "limit"));
  return entries;
}

std::string description(const std::vector<Panel>& panels, const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  std::string text = "Histograms of the parameters:";
  for (const MethodRow& row : method_rows(subject.assessment, kind, options))
    if (row.monte_carlo)
      text += fmt::format(" {} measured {}, mean {}, interval {} to {};", row.parameter->symbol, row.value,
                          row.monte_carlo->mean, row.monte_carlo->lower, row.monte_carlo->upper);
  if (!panels.empty()) text.back() = '.';
  return text;
}

double largest_magnitude(const std::vector<Panel>& panels, const Options& options) {
  double largest = 0.0;
  for (const Panel& panel : panels) {
    const Range range = range_of(panel, options);
    largest = std::max({largest, std::abs(range.low), std::abs(range.high)});
  }
  return largest;
}

}  // namespace

std::optional<Figure> distribution_figure(const Subject& subject, const Options& asked) {
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  if (!subject.assessment.monte_carlo) return std::nullopt;
  const std::vector<Panel> panels = panels_of(subject);
  if (panels.empty()) return std::nullopt;
  const AxisKind kind = subject.test.metadata.axis.kind;
  const plot::AxisUnit unit = plot::deviation_axis_unit(kind, options.unit, largest_magnitude(panels, options));
  Figure figure{.width = plot::plate_width, .height = 0.0, .title = {}, .description = {}, .operations = {}};
  const std::string words = translated(subject.assessment.label, options);
  double top = plot::draw_label(figure.operations, words, panel_margin, plot::plate_width - 2.0 * panel_margin);
  top += draw_legend(figure.operations, legend_of(panels, subject, options), {panel_margin, top},
                     plot::plate_width - panel_margin);
  const plot::Runs scale_note = plot::joined({plot::plain(translated("Scales", options) + " / ")}, unit.name);
  figure.operations.push_back(
      label(scale_note, {plot::plate_width - panel_margin, top + 6.0}, ink::tick_text_size, Anchor::end, ink::grey));
  top += 10.0;
  std::size_t rows_of_brackets = 0;
  for (const Panel& panel : panels) rows_of_brackets = std::max(rows_of_brackets, panel.brackets.size());
  const double brackets_height = bracket_row * static_cast<double>(rows_of_brackets);
  const double pitch = title_height + brackets_height + plot_height + panel_axis_height + row_gap;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const Point corner{panel_margin + static_cast<double>(k % columns) * (panel_width + panel_gap),
                       top + static_cast<double>(k / columns) * pitch};
    draw_panel(figure.operations, panels[k], corner, brackets_height, unit, subject, options);
  }
  figure.height = top + pitch * static_cast<double>((panels.size() + columns - 1) / columns) - row_gap + 2.0;
  const bool this_test = subject.assessment.monte_carlo->measurand == iso230_2::Measurand::this_test;
  figure.title = fmt::format("Distributions of the parameters of {} by the Monte Carlo method ({})",
                             plot::axis_phrase(subject), this_test ? "this test" : "this machine");
  figure.description = description(panels, subject, options);
  return figure;
}

}  // namespace axiometry::report
