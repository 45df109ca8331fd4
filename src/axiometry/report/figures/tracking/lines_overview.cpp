// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/tracking/lines_overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/counted.h"
#include "axiometry/model/aligned.h"
#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/series_pens.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using plot::Chart;
using plot::ChartAxis;
using plot::ChartRange;
using plot::header_left;
using plot::LegendEntry;
using plot::Operations;
namespace ink = plot::ink;

constexpr double overview_height = 240.0;

struct Mean {
  double distance_mm = 0.0;
  double deviation_um = 0.0;
  double position_mm = 0.0;
};

/// In order of distance; targets without a reading are left out.
std::vector<Mean> means_of(const AssessedLine& line) {
  std::vector<Mean> means;
  const auto& positions = line.assessment.evaluation.positions;
  for (std::size_t k = 0; k < std::min(positions.size(), line.line.distances_mm.size()); ++k) {
    const auto& p = positions[k];
    const auto mean = p.mean ? p.mean : p.mean_up ? p.mean_up : p.mean_down;
    if (mean && std::isfinite(line.line.distances_mm[k]))
      means.push_back({line.line.distances_mm[k], mean->in_native(), p.target.in_native()});
  }
  std::ranges::stable_sort(means, {}, &Mean::distance_mm);
  return means;
}

/// Least and largest of a member over all lines.
template <typename Member>
ChartRange range_of(const std::vector<std::vector<Mean>>& all, Member member) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& means : all)
    for (const Mean& mean : means) {
      low = std::min(low, mean.*member);
      high = std::max(high, mean.*member);
    }
  return low <= high ? ChartRange{low, high} : ChartRange{0.0, 1.0};
}

/// The straight line of the stated slope through the middle of the means, within the diagram.
void draw_slope(Operations& operations, const Chart& chart, const std::vector<Mean>& means, double slope_um_per_m,
                const Stroke& pen) {
  if (means.size() < 2 || !std::isfinite(slope_um_per_m)) return;
  double x = 0.0, y = 0.0;
  for (const Mean& mean : means) {
    x += mean.distance_mm / static_cast<double>(means.size());
    y += mean.deviation_um / static_cast<double>(means.size());
  }
  const bool grows = means.back().position_mm >= means.front().position_mm;
  const double per_mm = (grows ? 1e-3 : -1e-3) * slope_um_per_m;
  const auto at = [&](double distance) {
    return Point{chart.x(distance), std::clamp(chart.y(y + per_mm * (distance - x)), chart.top, chart.bottom)};
  };
  operations.push_back(plot::line(at(means.front().distance_mm), at(means.back().distance_mm),
                                  ink::solid(ink::faint(pen.colour, 0.45), 0.4)));
}

void draw_means(Operations& operations, const Chart& chart, const std::vector<Mean>& means, const Stroke& pen) {
  Path path{.points = {}, .closed = false, .stroke = pen, .fill = ink::none};
  for (const Mean& mean : means) path.points.push_back({chart.x(mean.distance_mm), chart.y(mean.deviation_um)});
  const std::vector<Point> points = path.points;
  if (points.size() > 1) operations.push_back(std::move(path));
  constexpr std::size_t most_marks = 60;
  if (points.size() > most_marks) return;
  for (const Point& point : points)
    operations.push_back(Disc{.centre = point, .radius = 1.2, .fill = pen.colour, .stroke = {.width = 0.0}});
}

LegendEntry entry(const AssessedLine& line, const Stroke& pen, const Options& options) {
  std::string text = plot::shortened(line.line.id, 90.0, ink::text_size);
  if (const double slope = line.line.slope_um_per_m; std::isfinite(slope))
    text += fmt::format(" ({}\u00a0µm/m)", format_fixed(slope, 2, options.numbers));
  return {.line = pen,
          .band = std::nullopt,
          .mark = Disc{.centre = {}, .radius = 1.2, .fill = pen.colour, .stroke = {.width = 0.0}},
          .text = {plot::plain(text)}};
}

}  // namespace

Figure lines_overview_figure(const LinesSubject& subject, const Options& options) {
  Figure figure{.width = plot::plate_width,
                .height = 0.0,
                .title = is_aligned(subject.plan.setup)
                             ? "Mean deviation of all lines over the distance from their beginning; in brackets the "
                               "slope"
                             : "Mean deviation of all lines over the distance from the station; in brackets the slope",
                .description = fmt::format("The means of {} at {} targets.", counted(subject.lines.size(), "line"),
                                           subject.lines.size() == 1 ? "its" : "their"),
                .operations = {}};
  std::vector<std::vector<Mean>> all;
  std::vector<LegendEntry> entries;
  for (const AssessedLine& line : subject.lines) {
    entries.push_back(entry(line, plot::series_pen(all.size()), options));
    all.push_back(means_of(line));
  }
  const double top =
      plot::draw_legend(figure.operations, entries, {header_left, 0.0}, plot::plate_width - header_left) + 8.0;
  figure.height = top + overview_height;
  const ChartRange x = plot::with_room(range_of(all, &Mean::distance_mm), 0.02);
  const ChartRange y = plot::with_room(range_of(all, &Mean::deviation_um));
  const ChartAxis distance{
      .low = x.low,
      .high = x.high,
      .unit = plot::position_axis_unit(AxisKind::linear, std::max(std::abs(x.low), std::abs(x.high))),
      .title = translated(is_aligned(subject.plan.setup) ? "Distance from the beginning" : "Distance from the station",
                          options)};
  const ChartAxis deviation{
      .low = y.low,
      .high = y.high,
      .unit = plot::deviation_axis_unit(AxisKind::linear, options.unit, std::max(std::abs(y.low), std::abs(y.high))),
      .title = translated("Mean deviation", options)};
  const Chart chart = plot::draw_chart(figure.operations, distance, deviation, top, figure.height, options.numbers);
  for (std::size_t k = 0; k < all.size(); ++k)
    draw_slope(figure.operations, chart, all[k], subject.lines[k].line.slope_um_per_m, plot::series_pen(k));
  for (std::size_t k = 0; k < all.size(); ++k) draw_means(figure.operations, chart, all[k], plot::series_pen(k));
  return figure;
}

}  // namespace axiometry::report
