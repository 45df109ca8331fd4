// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/mean_deviations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/shown_targets.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using plot::Chart;
using plot::ChartAxis;
namespace ink = plot::ink;

constexpr double means_height = 210.0;
constexpr double under_means_legend = 2.0;
constexpr double widest_cap = 3.0;      // half the width of the end of a bar, points
constexpr double share_of_pitch = 0.3;  // of the distance between two targets, at most
const Stroke mean_joined = ink::solid(ink::faint(ink::black, 0.35), 0.6);
const Stroke uncertainty_bar = ink::solid(ink::blue, 0.9);
const Disc mean_mark{.centre = {}, .radius = 1.9, .fill = ink::black};

/// One target: a mean and its expanded uncertainty.
struct MeanAt {
  double position = 0.0;
  double mean = 0.0;
  double low = 0.0;  // ends of the bar
  double high = 0.0;
  double k = 2.0;  // coverage factor, of the law of propagation

  double half() const { return 0.5 * (high - low); }
};

enum class MeanOf { both, up, down };

std::optional<MeanAt> mean_at(const iso230_2::PositionResult& result, const iso230_2::PositionUncertainty& known,
                              MeanOf of) {
  const auto with = [&](const std::optional<Deviation>& mean,
                        const iso230_2::ExpandedUncertainty& u) -> std::optional<MeanAt> {
    if (!mean) return std::nullopt;
    const double x = mean->in_native(), U = u.U.in_native();
    return MeanAt{result.target.in_native(), x, x - U, x + U, u.k};
  };
  if (of == MeanOf::both && known.mean) return with(result.mean, *known.mean);
  if (of == MeanOf::up && known.up) return with(result.mean_up, known.up->total);
  if (of == MeanOf::down && known.down) return with(result.mean_down, known.down->total);
  return std::nullopt;
}

/// Nothing where no source acts on any of them, and of a single one.
std::vector<MeanAt> worth_drawing(std::vector<MeanAt> means) {
  const bool none = std::ranges::all_of(means, [](const MeanAt& m) { return m.half() == 0.0; });
  if (none || means.size() < 2) means.clear();
  return means;
}

/// By the law of propagation, of the targets that are shown.
std::vector<MeanAt> propagated_means(const iso230_2::Assessment& assessment, MeanOf of) {
  const auto& known = assessment.gum->positions;
  const auto& results = assessment.evaluation.positions;
  std::vector<MeanAt> means;
  for (const std::size_t i : shown_targets(assessment.evaluation).places)
    if (i < known.size())
      if (const auto mean = mean_at(results[i], known[i], of)) means.push_back(*mean);
  return worth_drawing(std::move(means));
}

/// By the contributors of Annex A, of the targets that are shown.
std::vector<MeanAt> composed_means(const iso230_2::Assessment& assessment, MeanOf of) {
  const auto& known = assessment.annex_a->positions;
  const auto& results = assessment.evaluation.positions;
  std::vector<MeanAt> means;
  for (const std::size_t i : shown_targets(assessment.evaluation).places) {
    if (i >= known.size()) continue;
    const auto& own = of == MeanOf::both ? known[i].mean : of == MeanOf::up ? known[i].up : known[i].down;
    const auto& mean = of == MeanOf::both ? results[i].mean
                       : of == MeanOf::up ? results[i].mean_up
                                          : results[i].mean_down;
    if (!own || !mean) continue;
    const double x = mean->in_native(), U = own->U.in_native();
    means.push_back({results[i].target.in_native(), x, x - U, x + U});
  }
  return worth_drawing(std::move(means));
}

/// By trials.
std::vector<MeanAt> drawn_means(const iso230_2::Assessment& assessment, MeanOf of) {
  std::vector<MeanAt> means;
  for (const iso230_2::MeanDistribution& position : assessment.monte_carlo->means) {
    const auto& interval = of == MeanOf::both ? position.mean : of == MeanOf::up ? position.up : position.down;
    if (interval) means.push_back({position.target.in_native(), interval->value, interval->low, interval->high, 0.0});
  }
  return worth_drawing(std::move(means));
}

struct MeanTitles {
  std::string_view both, up, down;
};
constexpr MeanTitles propagated_titles{
    "Mean bidirectional positioning deviations with their expanded uncertainty (GUM)",
    "Mean unidirectional positioning deviations ↑ with their expanded uncertainty (GUM)",
    "Mean unidirectional positioning deviations ↓ with their expanded uncertainty (GUM)"};
constexpr MeanTitles composed_titles{
    "Mean bidirectional positioning deviations with their expanded uncertainty (contributors of Annex A)",
    "Mean unidirectional positioning deviations ↑ with their expanded uncertainty (contributors of Annex A)",
    "Mean unidirectional positioning deviations ↓ with their expanded uncertainty (contributors of Annex A)"};
constexpr MeanTitles drawn_titles{"Mean bidirectional positioning deviations with their intervals (Monte Carlo)",
                                  "Mean unidirectional positioning deviations ↑ with their intervals (Monte Carlo)",
                                  "Mean unidirectional positioning deviations ↓ with their intervals (Monte Carlo)"};

std::string_view title_of(const MeanTitles& titles, MeanOf of) {
  return of == MeanOf::both ? titles.both : of == MeanOf::up ? titles.up : titles.down;
}

plot::Runs mean_symbol(MeanOf of) {
  plot::Runs runs = {plot::barred("x"), plot::index_letter("i")};
  if (of != MeanOf::both) runs.push_back(plot::plain(of == MeanOf::up ? "↑" : "↓"));
  return runs;
}

/// "k = 2", or "k = 2.00 … 2.87" where degrees of freedom differ.
std::string coverage_text(const std::vector<MeanAt>& means, const Options& options) {
  const auto [least, most] = std::ranges::minmax(means, {}, &MeanAt::k);
  if (most.k - least.k < 0.005 && std::abs(least.k - 2.0) < 0.005) return " = 2";
  const std::string from = format_fixed(least.k, 2, options.numbers), to = format_fixed(most.k, 2, options.numbers);
  return from == to ? " = " + from : " = " + from + " … " + to;
}

void draw_means(plot::Operations& operations, const Chart& chart, const std::vector<MeanAt>& means) {
  std::vector<Point> points;
  double pitch = 2.0 * widest_cap / share_of_pitch;
  for (std::size_t k = 1; k < means.size(); ++k)
    pitch = std::min(pitch, std::abs(chart.x(means[k].position) - chart.x(means[k - 1].position)));
  const double cap = std::min(widest_cap, share_of_pitch * pitch);
  for (const MeanAt& m : means) {
    const double x = chart.x(m.position), low = chart.y(m.low), high = chart.y(m.high);
    operations.push_back(plot::line({x, low}, {x, high}, uncertainty_bar));
    for (const double end : {low, high})
      operations.push_back(plot::line({x - cap, end}, {x + cap, end}, uncertainty_bar));
    points.push_back({x, chart.y(m.mean)});
  }
  operations.push_back(plot::polyline(points, mean_joined));
  for (const Point& point : points) {
    Disc disc = mean_mark;
    disc.centre = point;
    disc.radius = std::min(mean_mark.radius, std::max(0.5, 0.4 * pitch));
    operations.push_back(disc);
  }
}

/// What the figures of the methods differ by.
struct MeanFigure {
  MeanOf of = MeanOf::both;
  std::vector<MeanAt> means;
  std::string_view title;
  std::string_view description;  // with places for the number of targets and the least and largest half of a bar
  plot::Runs bar;                // in the legend
};

/// The means that exist: of both directions, else of the one that there is.
template <typename Find>
MeanFigure means_to_draw(const MeanTitles& titles, const Find& find) {
  for (const MeanOf of : {MeanOf::both, MeanOf::up, MeanOf::down})
    if (auto means = find(of); !means.empty()) return {of, std::move(means), title_of(titles, of), {}, {}};
  return {};
}

Figure figure_of(const MeanFigure& drawn, const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto shown = [&](double half) { return shown_uncertainty(Deviation::native(half), scale, options); };
  const auto& means = drawn.means;
  const auto [least, most] = std::ranges::minmax(means, {}, &MeanAt::half);
  Figure figure{.width = plot::plate_width, .title = std::string(drawn.title)};
  figure.description =
      fmt::format(fmt::runtime(drawn.description), means.size(), shown(least.half()), shown(most.half()), scale.unit);
  const double under_label = plot::draw_label(figure.operations, translated(subject.assessment.label, options),
                                              plot::header_left, plot::plate_width);
  const double top =
      under_label +
      plot::draw_legend(figure.operations,
                        {{.line = std::nullopt, .band = std::nullopt, .mark = mean_mark, .text = mean_symbol(drawn.of)},
                         {.line = uncertainty_bar, .band = std::nullopt, .mark = std::nullopt, .text = drawn.bar}},
                        {plot::header_left, under_label}, plot::plate_width - plot::header_left) +
      under_means_legend;
  plot::Range y, x;
  for (const MeanAt& m : means) {
    for (const double value : {m.low, m.mean, m.high}) y.see(value);
    x.see(m.position);
  }
  const plot::ChartRange up = plot::with_room({y.low, y.high}), along = plot::with_room({x.low, x.high}, 0.02);
  const double largest = std::max(std::abs(x.low), std::abs(x.high));
  const ChartAxis position{.low = along.low,
                           .high = along.high,
                           .unit = plot::position_axis_unit(kind, largest),
                           .title = translated("Position", options),
                           .division = kind == AxisKind::rotary ? plot::Division::angular : plot::Division::decimal};
  const ChartAxis deviation{.low = up.low,
                            .high = up.high,
                            .unit = plot::deviation_axis_unit(kind, options.unit, y.magnitude()),
                            .title = translated("Deviation", options)};
  const Chart chart =
      plot::draw_chart(figure.operations, position, deviation, top, top + means_height, options.numbers);
  draw_means(figure.operations, chart, means);
  figure.height = top + means_height;
  return figure;
}

}  // namespace

std::optional<Figure> mean_deviation_figure(const Subject& subject, const Options& asked) {
  if (!subject.assessment.gum) return std::nullopt;
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  MeanFigure drawn =
      means_to_draw(propagated_titles, [&](MeanOf of) { return propagated_means(subject.assessment, of); });
  if (drawn.means.empty()) return std::nullopt;
  drawn.description = "{} targets; the expanded uncertainty is from {} to {} {}.";
  drawn.bar = {plot::plain("±\u2009"), plot::italic("U"), plot::plain(" ("), plot::italic("k"),
               plot::plain(coverage_text(drawn.means, options) + ")")};
  return figure_of(drawn, subject, options);
}

std::optional<Figure> mean_annex_a_figure(const Subject& subject, const Options& asked) {
  if (!subject.assessment.annex_a) return std::nullopt;
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  MeanFigure drawn = means_to_draw(composed_titles, [&](MeanOf of) { return composed_means(subject.assessment, of); });
  if (drawn.means.empty()) return std::nullopt;
  drawn.bar = {plot::plain("±\u2009"), plot::italic("U"), plot::plain(" ("), plot::italic("k"), plot::plain(" = 2)")};
  if (subject.assessment.annex_a->missing.empty()) {
    drawn.description = "{} targets; the expanded uncertainty is from {} to {} {}.";
  } else {
    drawn.description =
        "{} targets; the expanded uncertainty is from {} to {} {}, too small: not all contributors were given.";
    drawn.bar.push_back(
        plot::plain(", " + std::string(translated("too short: not all contributors were given", options))));
  }
  return figure_of(drawn, subject, options);
}

std::optional<Figure> mean_interval_figure(const Subject& subject, const Options& asked) {
  if (!subject.assessment.monte_carlo) return std::nullopt;
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  MeanFigure drawn = means_to_draw(drawn_titles, [&](MeanOf of) { return drawn_means(subject.assessment, of); });
  if (drawn.means.empty()) return std::nullopt;
  drawn.description = "{} targets; half the width of their intervals is from {} to {} {}.";
  const double percent = 100.0 * subject.assessment.monte_carlo->coverage;
  std::string share = format_exact(std::round(percent * 100.0) / 100.0);
  std::ranges::replace(share, '.', options.numbers.decimal_mark);
  drawn.bar = {plot::plain(translated(fmt::format("interval for {}\u00a0%", share), options))};
  return figure_of(drawn, subject, options);
}

}  // namespace axiometry::report
