// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"
#include "axiometry/volumetric/field/error_model.h"

namespace axiometry::report {

/// The error of the tool point with a tool of the machine on the three planes through the middle of the volume that was
/// observed: colours show |δ|, arrows the components within the plane, all in one scale. A plane of which the lengths
/// do not tell all stays without colour there.
Figure field_slice_figure(const volumetric::ErrorModel& model, std::size_t tool, const Options& options);

}  // namespace axiometry::report
