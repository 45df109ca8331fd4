// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/dimension_line.h"

#include <algorithm>
#include <utility>

#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report::plot {
namespace {

constexpr double head_length = 4.6;
constexpr double head_half_width = 1.25;
constexpr double line_width = 0.5;
constexpr double extension_width = 0.3;
constexpr double shortest_with_heads_within = 2.0 * head_length + 2.5;

bool heads_fit_within(const DimensionLine& d) { return d.bottom - d.top >= shortest_with_heads_within; }

/// A filled head with its tip at `tip`; direction +1 points down the paper.
Path arrow_head(Point tip, double direction) {
  const double base = tip.y - direction * head_length;
  return {.points = {tip, {tip.x - head_half_width, base}, {tip.x + head_half_width, base}},
          .closed = true,
          .stroke = ink::solid(ink::black, 0.0),
          .fill = ink::black};
}

}  // namespace

Path line(Point from, Point to, const Stroke& stroke) {
  return {.points = {from, to}, .closed = false, .stroke = stroke, .fill = ink::none};
}

Path polyline(std::vector<Point> points, const Stroke& stroke) {
  return {.points = std::move(points), .closed = false, .stroke = stroke, .fill = ink::none};
}

void draw_extension_line(Operations& operations, double from_x, double to_x, double y, std::vector<Gap> gaps) {
  const Stroke hairline = ink::solid(ink::extension_grey, extension_width);
  std::ranges::sort(gaps, {}, &Gap::from);
  double x = from_x;
  for (const Gap& gap : gaps) {
    if (gap.to <= x || gap.from >= to_x) continue;
    if (gap.from > x) operations.push_back(line({x, y}, {gap.from, y}, hairline));
    x = gap.to;
  }
  if (x < to_x) operations.push_back(line({x, y}, {to_x, y}, hairline));
}

void draw_dimension_line(Operations& operations, const DimensionLine& d) {
  const Stroke stroke = ink::solid(ink::black, line_width);
  if (heads_fit_within(d)) {
    operations.push_back(line({d.x, d.top + head_length / 2}, {d.x, d.bottom - head_length / 2}, stroke));
    operations.push_back(arrow_head({d.x, d.top}, -1.0));
    operations.push_back(arrow_head({d.x, d.bottom}, 1.0));
    return;
  }
  operations.push_back(line({d.x, d.top - outside_arrow_length}, {d.x, d.top - head_length / 2}, stroke));
  operations.push_back(line({d.x, d.bottom + head_length / 2}, {d.x, d.bottom + outside_arrow_length}, stroke));
  operations.push_back(arrow_head({d.x, d.top}, 1.0));
  operations.push_back(arrow_head({d.x, d.bottom}, -1.0));
}

void draw_dimension_line(Operations& operations, const LevelDimensionLine& d) {
  // Drawn upright, then turned: what stood at (x, y) stands at (y, x).
  Operations upright;
  draw_dimension_line(upright, DimensionLine{.x = d.y, .top = d.left, .bottom = d.right});
  for (Operation& operation : upright) {
    Path path = std::get<Path>(std::move(operation));
    for (Point& point : path.points) std::swap(point.x, point.y);
    operations.push_back(std::move(path));
  }
}

double upper_end(const DimensionLine& d) { return heads_fit_within(d) ? d.top : d.top - outside_arrow_length; }

}  // namespace axiometry::report::plot
