// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What plates and plain diagrams have in common about their axes, points. Private to this folder.
namespace axiometry::report::plot {

inline constexpr double figure_edge = 2.0;   ///< left free
inline constexpr double title_room = 13.0;   ///< room for the title of the y axis
inline constexpr double tick_and_gap = 6.0;  ///< gap between its labels and the axis
inline constexpr double below_plot = 29.0;   ///< labels and title of the x axis
inline constexpr double tick_length = 3.0;
inline constexpr double axis_width = 0.6;

}  // namespace axiometry::report::plot
