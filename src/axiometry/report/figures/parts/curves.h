// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate_layout.h"

namespace axiometry::report::plot {

/// Bands, boundaries, readings and means of the plate. A line breaks where a target lacks what it
/// joins: nothing is drawn that was not measured.
void draw_curves(Operations& operations, const Plate& plate, const PlateLayout& layout);

/// An entry for each kind of curve that draw_curves() draws.
std::vector<LegendEntry> legend_of(const Plate& plate);

}  // namespace axiometry::report::plot
