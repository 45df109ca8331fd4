// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/base/text/number_text.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/figures/parts/symbols.h"

/// One of several small diagrams in a figure, which share their axes.
namespace axiometry::report::plot {

/// Where it stands on paper, what it shows, and which of its axes are labelled. Contract: finite, low < high.
struct Pane {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
  Range across, up;
  bool x_labels = true;
  bool y_labels = true;
  bool x_ticks = true;  ///< whether there are ticks and a grid; else names instead of numbers

  double x(double value) const { return left + (value - across.low) / across.size() * (right - left); }
  double y(double value) const { return bottom - (value - up.low) / up.size() * (bottom - top); }
  Point at(double across_value, double up_value) const { return {x(across_value), y(up_value)}; }
};

/// Grid, zero line, frame and labels.
void draw_pane(Operations& operations, const Pane& pane, NumberStyle style);

/// Points between the left edge of the tick labels and the axis, of a pane with these values and this height.
double pane_label_width(const Range& up, double height, NumberStyle style);

/// Above the pane, at its left.
void draw_pane_title(Operations& operations, const Pane& pane, Runs runs);

/// In the middle of an empty pane, over its lines.
void draw_pane_remark(Operations& operations, const Pane& pane, std::string text);

/// Upright, left of everything.
void draw_upright_title(Operations& operations, Runs runs, Point middle);

inline constexpr double pane_title_room = 12.0;  ///< room above a pane
inline constexpr double pane_label_room = 13.0;  ///< room of the x labels, below it
inline constexpr double pane_axis_room = 25.0;   ///< room of the x labels and the title of the axis

}  // namespace axiometry::report::plot
