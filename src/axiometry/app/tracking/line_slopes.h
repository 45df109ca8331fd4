// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

namespace axiometry::app {

/// The slope of each line of a plan, µm/m: the least-squares line through length shown − nominal distance, over the
/// distance |q + t − s|; all readings of a line weigh the same. A line without two distances is an error.
Result<std::vector<double>> slopes_um_per_m(const TrackingPlan& plan, std::span<const LengthReading> readings);

}  // namespace axiometry::app
