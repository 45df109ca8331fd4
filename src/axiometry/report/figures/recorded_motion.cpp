// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/recorded_motion.h"

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/figures/parts/series_pens.h"
#include "axiometry/report/figures/parts/thinned.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

constexpr double recorded_height = 104.0;
constexpr double recorded_width = 0.5;  // of the line: what is dense stays readable
constexpr double shade = 0.12;

}  // namespace

Figure recorded_figure(const RecordedCurve& curve, const Options& options) {
  plot::Range x, y;
  for (const auto& line : curve.lines)
    for (const Point& p : line) {
      x.see(p.x);
      y.see(p.y);
    }
  if (curve.from_zero) y.see(0.0);
  if (!x.any()) x.see(0.0), y.see(0.0);
  Figure figure{.width = plot::plate_width,
                .height = recorded_height,
                .title = curve.title,
                .description = curve.description,
                .operations = {}};
  plot::ChartRange up = plot::with_room({y.low, y.high});
  if (curve.from_zero) up.low = 0.0;
  const plot::ChartRange across = plot::with_room({x.low, x.high}, 0.0);
  const plot::ChartAxis horizontal{.low = across.low,
                                   .high = across.high,
                                   .unit = {1.0, {plot::plain(curve.x_unit)}},
                                   .title = translated(curve.x_title, options)};
  const plot::ChartAxis vertical{.low = up.low,
                                 .high = up.high,
                                 .unit = {1.0, {plot::plain(curve.y_unit)}},
                                 .title = translated(curve.y_title, options)};
  std::vector<plot::LegendEntry> entries;
  for (std::size_t k = 0; k < curve.names.size(); ++k)
    entries.push_back({plot::series_pen(k), std::nullopt, std::nullopt, {plot::plain(curve.names[k])}});
  const double top = 2.0 + (entries.empty() ? 0.0
                                            : plot::draw_legend(figure.operations, entries, {plot::header_left, 0.0},
                                                                plot::plate_width - plot::header_left));
  figure.height += top - 2.0;
  const plot::Chart chart =
      plot::draw_chart(figure.operations, horizontal, vertical, top, figure.height, options.numbers);
  for (const auto& [from, to] : curve.shaded)
    figure.operations.push_back(Path{.points = {{chart.x(from), chart.top},
                                                {chart.x(to), chart.top},
                                                {chart.x(to), chart.bottom},
                                                {chart.x(from), chart.bottom}},
                                     .closed = true,
                                     .stroke = {.width = 0.0},
                                     .fill = plot::ink::faint(plot::ink::blue, shade)});
  for (std::size_t k = 0; k < curve.lines.size(); ++k) {
    std::vector<Point> points;
    for (const Point& p : curve.lines[k]) points.push_back({chart.x(p.x), chart.y(p.y)});
    Stroke pen = plot::series_pen(k);
    pen.width = recorded_width;
    figure.operations.push_back(plot::polyline(plot::thinned(std::move(points)), pen));
  }
  return figure;
}

}  // namespace axiometry::report
