// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/figures/parts/plate_layout.h"

namespace axiometry::report::plot {

/// Grid hairlines and the emphasised zero line; drawn first, under the curves.
void draw_grid(Operations& operations, const PlateLayout& layout);

/// Axis lines, tick labels, axis titles, and the targets' numbers i along the top. Where targets stand
/// close, numbers that would touch are left out; those of `plate.at_targets` are never.
void draw_axes(Operations& operations, const Plate& plate, const PlateLayout& layout);

}  // namespace axiometry::report::plot
