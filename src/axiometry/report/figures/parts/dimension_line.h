// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/report/drawing/figure.h"

namespace axiometry::report::plot {

using Operations = std::vector<Operation>;

Path line(Point from, Point to, const Stroke& stroke);
Path polyline(std::vector<Point> points, const Stroke& stroke);  ///< open

/// Stretches of a line that labels leave free.
struct Gap {
  double from = 0.0;
  double to = 0.0;
};

/// A horizontal hairline that carries one end of a dimension out of the drawing, broken at the gaps.
void draw_extension_line(Operations& operations, double from_x, double to_x, double y, std::vector<Gap> gaps);

/// Upright dimension lines: arrow heads within, or, where they do not fit, from outside pointing inwards.
struct DimensionLine {
  double x = 0.0;
  double top = 0.0;  ///< y on paper, ≤ bottom
  double bottom = 0.0;
};
void draw_dimension_line(Operations& operations, const DimensionLine& dimension);

/// The same, level.
struct LevelDimensionLine {
  double y = 0.0;
  double left = 0.0;  ///< ≤ right
  double right = 0.0;
};
void draw_dimension_line(Operations& operations, const LevelDimensionLine& dimension);

/// Upper end of what draw_dimension_line() draws: `top`, or the tail of the upper outside arrow.
double upper_end(const DimensionLine& dimension);

/// Space a dimension line with outside arrows needs above `top` and below `bottom`, points.
inline constexpr double outside_arrow_length = 9.0;

}  // namespace axiometry::report::plot
