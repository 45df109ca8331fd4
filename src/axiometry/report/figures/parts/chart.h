// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/scale.h"

/// A plain diagram: two axes with round divisions, a grid and titles. What is drawn in it is the caller's.
namespace axiometry::report::plot {

/// One axis, in native units. Contract: finite, low < high; with `logarithmic` low > 0.
struct ChartAxis {
  double low = 0.0;
  double high = 1.0;
  AxisUnit unit;      ///< unit in which it is labelled
  std::string title;  ///< "Deviation"; the unit follows
  Division division = Division::decimal;
  bool logarithmic = false;
};

/// Where the diagram stands and how native values come onto paper.
struct Chart {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
  ChartAxis x_axis;
  ChartAxis y_axis;

  double x(double native) const { return place(x_axis, native, left, right); }
  double y(double native) const { return place(y_axis, native, bottom, top); }

  static double place(const ChartAxis& axis, double native, double from, double to);
};

/// Draws grid, zero line, axes, labels and titles between `top` and `bottom` over the whole width of a figure, and says
/// where it drew. Everything of it lies between these two.
Chart draw_chart(Operations& operations, const ChartAxis& x, const ChartAxis& y, double top, double bottom,
                 NumberStyle style);

/// Low and high with a little room at both ends; a range of nothing gets one.
struct ChartRange {
  double low = 0.0;
  double high = 0.0;
};
ChartRange with_room(ChartRange range, double share = 0.06);

}  // namespace axiometry::report::plot
