// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"
#include "axiometry/volumetric/field/error_model.h"

namespace axiometry::report {

/// The six error motions of an axis (0 to 2) over its position: three displacements in a row, µm, and three rotations
/// below, µrad, each row in one scale, with bands ±U (k = 2). Where the directions of an axis have curves of their own,
/// a line for each of them within the band of their mean. An error of which the lengths do not tell all has a pane
/// that says so.
Figure error_motion_figure(const volumetric::ErrorModel& model, std::size_t axis, const Options& options);

}  // namespace axiometry::report
