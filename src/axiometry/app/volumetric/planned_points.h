// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/machine/volumetric_data.h"
#include "axiometry/volumetric/plan/calibration_plan.h"

namespace axiometry::app {

/// Whether lengths were taken where a plan has them, to 0.001 mm. Fails where at least half of the lengths of a station
/// and tool, and three, stand at points of another part and fewer at those of their own: they were taken with another
/// station or tool than the table says. Lengths at no point of their part are told.
Result<std::vector<volumetric::VolumetricFinding>> check_planned(const volumetric::CalibrationPlan& plan,
                                                                 const volumetric::VolumetricLengths& lengths);

}  // namespace axiometry::app
