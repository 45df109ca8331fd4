// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/symbols.h"

namespace axiometry::report::plot {

/// Where label and legend begin: about where the plot below them does, which depends on its tick labels.
inline constexpr double header_left = 30.0;

/// One entry: a short sample of what is drawn, and what it is.
struct LegendEntry {
  std::optional<Stroke> line;
  std::optional<Colour> band;  ///< filled behind the line
  std::optional<Disc> mark;    ///< its centre is set by the legend
  Runs text;
};

/// Draws the entries in rows from the top left and returns the height they take.
double draw_legend(Operations& operations, const std::vector<LegendEntry>& entries, Point top_left, double width);

/// The label that must stand wherever results do (Assessment::label), in bold above everything else, cut where it is
/// too long. Returns the height it takes: none for an empty one.
double draw_label(Operations& operations, std::string_view label, double left, double width);

}  // namespace axiometry::report::plot
