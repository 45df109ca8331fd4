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
  double U = 0.0;
  double k = 2.0;  // coverage factor
};

enum class MeanOf { both, up, down };

std::optional<MeanAt> mean_at(const iso230_2::PositionResult& result, const iso230_2::PositionUncertainty& known,
                              MeanOf of) {
  const auto with = [&](const std::optional<Deviation>& mean,
                        const iso230_2::ExpandedUncertainty& u) -> std::optional<MeanAt> {
    if (!mean) return std::nullopt;
    return MeanAt{result.target.in_native(), mean->in_native(), u.U.in_native(), u.k};
  };
  if (of == MeanOf::both && known.mean) return with(result.mean, *known.mean);
  if (of == MeanOf::up && known.up) return with(result.mean_up, known.up->total);
  if (of == MeanOf::down && known.down) return with(result.mean_down, known.down->total);
  return std::nullopt;
}

/// Of the targets that are shown; empty where no source acts on any of them, and of a single one.
std::vector<MeanAt> means_of(const iso230_2::Assessment& assessment, MeanOf of) {
  const auto& known = assessment.gum->positions;
  const auto& results = assessment.evaluation.positions;
  std::vector<MeanAt> means;
  for (const std::size_t i : shown_targets(assessment.evaluation).places)
    if (i < known.size())
      if (const auto mean = mean_at(results[i], known[i], of)) means.push_back(*mean);
  const bool none = std::ranges::all_of(means, [](const MeanAt& m) { return m.U == 0.0; });
  if (none || means.size() < 2) means.clear();
  return means;
}

std::string_view title_of(MeanOf of) {
  switch (of) {
    case MeanOf::both: return "Mean bidirectional positioning deviations with their expanded uncertainty (GUM)";
    case MeanOf::up: return "Mean unidirectional positioning deviations ↑ with their expanded uncertainty (GUM)";
    case MeanOf::down: return "Mean unidirectional positioning deviations ↓ with their expanded uncertainty (GUM)";
  }
  return "";
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
    const double x = chart.x(m.position), low = chart.y(m.mean - m.U), high = chart.y(m.mean + m.U);
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

}  // namespace

std::optional<Figure> mean_deviation_figure(const Subject& subject, const Options& asked) {
  if (!subject.assessment.gum) return std::nullopt;
  MeanOf of = MeanOf::both;
  std::vector<MeanAt> means;
  for (const MeanOf one : {MeanOf::both, MeanOf::up, MeanOf::down}) {
    if (!means.empty()) break;
    of = one;
    means = means_of(subject.assessment, one);
  }
  if (means.empty()) return std::nullopt;
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  const AxisKind kind = subject.test.metadata.axis.kind;
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto shown_U = [&](double U) { return shown_uncertainty(Deviation::native(U), scale, options); };
  const auto [least, most] = std::ranges::minmax(means, {}, &MeanAt::U);
  Figure figure{.width = plot::plate_width, .title = std::string(title_of(of))};
  figure.description = fmt::format("{} targets; the expanded uncertainty is from {} to {} {}.", means.size(),
                                   shown_U(least.U), shown_U(most.U), scale.unit);
  const double under_label = plot::draw_label(figure.operations, translated(subject.assessment.label, options),
                                              plot::header_left, plot::plate_width);
  const plot::Runs bar = {plot::plain("±\u2009"), plot::italic("U"), plot::plain(" ("), plot::italic("k"),
                          plot::plain(coverage_text(means, options) + ")")};
  const double top =
      under_label +
      plot::draw_legend(figure.operations,
                        {{.line = std::nullopt, .band = std::nullopt, .mark = mean_mark, .text = mean_symbol(of)},
                         {.line = uncertainty_bar, .band = std::nullopt, .mark = std::nullopt, .text = bar}},
                        {plot::header_left, under_label}, plot::plate_width - plot::header_left) +
      under_means_legend;
  plot::Range y, x;
  for (const MeanAt& m : means) {
    y.see(m.mean - m.U);
    y.see(m.mean + m.U);
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

}  // namespace axiometry::report
