// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/axis_motion.h"

#include <fmt/format.h>

#include <vector>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using error_motions::AxisMotion;
using error_motions::MotionPath;
using error_motions::PathKind;

constexpr double motion_height = 210.0;
constexpr std::size_t most_motion_dots = 400;
const Stroke reference_pen{.colour = plot::ink::black, .width = 0.9, .dashes = {5.0, 2.2}};

plot::AxisUnit motion_axis_unit(MotionUnit unit, const Options& options, double largest) {
  if (unit == MotionUnit::urad) return {1.0, {plot::plain(motion_unit_symbol(unit))}};
  return plot::deviation_axis_unit(unit == MotionUnit::um ? AxisKind::linear : AxisKind::rotary, options.unit, largest);
}

struct AxisMotionDrawing {
  const AxisMotion& motion;
  const Options& options;
  bool residuals = false;

  /// Of a direction, less the line of the principal course where residuals are shown.
  double value(const MotionPath& path, std::size_t i) const {
    const MotionPath& principal = motion.principal();
    return residuals ? principal.residuals[i] + (path.means[i] - principal.means[i]) : path.means[i];
  }

  bool shown(const MotionPath& path) const { return path.kind != PathKind::mean; }

  Figure draw(const std::string& title) const {
    plot::Range x, y;
    const bool line = !residuals && motion.reference != error_motions::Reference::none;
    for (std::size_t i = 0; i < motion.positions.size(); ++i) {
      x.see(motion.positions[i].position_mm);
      if (line) y.see(on_line(i));
      for (const MotionPath& path : motion.paths)
        if (shown(path)) y.see(value(path, i));
    }
    Figure figure{.width = plot::plate_width,
                  .height = motion_height,
                  .title = title,
                  .description = fmt::format("Means at {} positions.", motion.positions.size()),
                  .operations = {}};
    const double top = plot::draw_legend(figure.operations, entries(line), {plot::header_left, 0.0},
                                         plot::plate_width - plot::header_left) +
                       2.0;
    const plot::ChartRange across = plot::with_room({x.low, x.high}, 0.02), up = plot::with_room({y.low, y.high});
    const plot::ChartAxis position{.low = across.low,
                                   .high = across.high,
                                   .unit = plot::position_axis_unit(AxisKind::linear, x.magnitude()),
                                   .title = translated("Position", options)};
    const plot::ChartAxis reading{.low = up.low,
                                  .high = up.high,
                                  .unit = motion_axis_unit(motion.unit, options, y.magnitude()),
                                  .title = translated(residuals ? "Residual" : "Reading", options)};
    const plot::Chart chart =
        plot::draw_chart(figure.operations, position, reading, top, motion_height, options.numbers);
    if (line) {
      const std::size_t last = motion.positions.size() - 1;
      figure.operations.push_back(plot::polyline(
          {{chart.x(x.low), chart.y(on_line(0))}, {chart.x(x.high), chart.y(on_line(last))}}, reference_pen));
    }
    for (const MotionPath& path : motion.paths)
      if (shown(path)) draw_path(figure.operations, chart, path);
    return figure;
  }

  /// About the residuals, which a far zero costs no digits.
  double on_line(std::size_t i) const { return motion.principal().means[i] - motion.principal().residuals[i]; }

  static Direction direction_of(const MotionPath& path) {
    return path.kind == PathKind::down ? Direction::down : Direction::up;
  }

  static Disc dot(const MotionPath& path) {
    return {.centre = {}, .radius = 1.4, .fill = plot::ink::of(direction_of(path)), .stroke = {.width = 0.0}};
  }

  void draw_path(plot::Operations& operations, const plot::Chart& chart, const MotionPath& path) const {
    std::vector<Point> points;
    for (std::size_t i = 0; i < motion.positions.size(); ++i)
      points.push_back({chart.x(motion.positions[i].position_mm), chart.y(value(path, i))});
    operations.push_back(plot::polyline(points, plot::ink::mean_line(direction_of(path))));
    if (points.size() > most_motion_dots) return;
    Disc mark = dot(path);
    for (const Point& point : points) {
      mark.centre = point;
      operations.push_back(mark);
    }
  }

  std::vector<plot::LegendEntry> entries(bool line) const {
    std::vector<plot::LegendEntry> list;
    for (const MotionPath& path : motion.paths)
      if (shown(path)) {
        const std::string what =
            translated(motion.runs > 1 ? fmt::format("mean of {} runs", motion.runs) : std::string("reading"), options);
        list.push_back({.line = plot::ink::mean_line(direction_of(path)),
                        .band = std::nullopt,
                        .mark = dot(path),
                        .text = {plot::plain(fmt::format("{} {}", path_mark(path.kind), what))}});
      }
    if (line)
      list.push_back({.line = reference_pen,
                      .band = std::nullopt,
                      .mark = std::nullopt,
                      .text = {plot::plain(translated("straight line", options))}});
    return list;
  }
};

}  // namespace

Figure motion_figure(const AxisMotion& motion, const std::string& title, const Options& options) {
  return AxisMotionDrawing{motion, options, false}.draw(title);
}

Figure motion_residual_figure(const AxisMotion& motion, const std::string& title, const Options& options) {
  return AxisMotionDrawing{motion, options, true}.draw(title);
}

}  // namespace axiometry::report
