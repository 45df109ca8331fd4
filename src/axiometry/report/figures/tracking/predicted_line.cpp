// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/tracking/predicted_line.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using plot::Chart;
using volumetric::Estimate;
using volumetric::LineComparison;
using volumetric::PredictedLine;
namespace ink = plot::ink;

constexpr double line_height = 190.0;
constexpr double line_coverage = 2.0;
constexpr double line_band_alpha = 0.16;

void draw_direction(plot::Operations& operations, const Chart& chart, std::span<const double> positions,
                    std::span<const Estimate> values, Direction direction) {
  std::vector<Point> band, line;
  for (std::size_t k = 0; k < values.size(); ++k) {
    band.push_back({chart.x(positions[k]), chart.y(values[k].value + line_coverage * values[k].u)});
    line.push_back({chart.x(positions[k]), chart.y(values[k].value)});
  }
  for (std::size_t k = values.size(); k-- > 0;)
    band.push_back({chart.x(positions[k]), chart.y(values[k].value - line_coverage * values[k].u)});
  operations.push_back(Path{.points = std::move(band),
                            .closed = true,
                            .stroke = ink::solid(ink::faint(ink::of(direction), 0.4), 0.4),
                            .fill = ink::faint(ink::of(direction), line_band_alpha)});
  operations.push_back(plot::polyline(std::move(line), ink::mean_line(direction)));
}

plot::LegendEntry predicted_entry(Direction direction, const char* words, const Options& options) {
  return {.line = ink::mean_line(direction),
          .band = ink::faint(ink::of(direction), line_band_alpha),
          .mark = std::nullopt,
          .text = {plot::plain(translated(words, options) + ", ±"), plot::italic("U"), plot::plain(" ("),
                   plot::italic("k"), plot::plain(" = 2)")}};
}

}  // namespace

Figure predicted_line_figure(const PredictedLine& predicted, const std::optional<LineComparison>& comparison,
                             const Options& options) {
  Figure figure{.width = plot::plate_width,
                .title = "Deviations along the line, as predicted",
                .description = "What a test along the line would show, with the band in which it lies."};
  std::vector<plot::LegendEntry> entries;
  entries.push_back(predicted_entry(Direction::up, predicted.has_directions ? "predicted ↑" : "predicted", options));
  if (predicted.has_directions) entries.push_back(predicted_entry(Direction::down, "predicted ↓", options));
  if (comparison)
    entries.push_back({.line = std::nullopt,
                       .band = std::nullopt,
                       .mark = Disc{.centre = {}, .radius = 1.9, .fill = ink::black},
                       .text = {plot::plain(translated("measured", options))}});
  const double top =
      plot::draw_legend(figure.operations, entries, {plot::header_left, 0.0}, plot::plate_width - plot::header_left) +
      4.0;
  plot::Range range;
  for (const auto* values : {&predicted.up, &predicted.down})
    for (const Estimate& e : *values) {
      range.see(e.value - line_coverage * e.u);
      range.see(e.value + line_coverage * e.u);
    }
  if (comparison)
    for (const double x : comparison->measured_um) range.see(x);
  const auto& positions = predicted.line.positions_mm;
  const plot::ChartRange up = plot::with_room({range.low, range.high});
  const plot::ChartRange along = plot::with_room({positions.front(), positions.back()}, 0.02);
  figure.height = top + line_height + 34.0;
  const Chart chart = plot::draw_chart(
      figure.operations,
      {.low = along.low,
       .high = along.high,
       .unit = {1.0, {plot::plain("mm")}},
       .title = translated("Position", options)},
      {.low = up.low, .high = up.high, .unit = {1.0, {plot::plain("µm")}}, .title = translated("Deviation", options)},
      top, figure.height, options.numbers);
  draw_direction(figure.operations, chart, positions, predicted.up, Direction::up);
  if (predicted.has_directions) draw_direction(figure.operations, chart, positions, predicted.down, Direction::down);
  if (comparison)
    for (std::size_t k = 0; k < comparison->measured_um.size(); ++k)
      figure.operations.push_back(
          Disc{.centre = {chart.x(positions[k % positions.size()]), chart.y(comparison->measured_um[k])},
               .radius = 1.9,
               .fill = ink::black});
  return figure;
}

}  // namespace axiometry::report
