// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/volumetric/plan/calibration_plan.h"

/// The whole way of a run, as a program drives it.
namespace axiometry::volumetric {

struct WayPoint {
  Vector3 axes_mm;
  bool is_reading = false;
  bool beam_kept = true;  ///< whether the beam was kept since the reading before
};

/// From above the first stop (Z at its highest, where the way down is free) over all stops to above the last.
std::vector<WayPoint> way_of(const CalibrationPlan& plan, const PlannedRun& run);

}  // namespace axiometry::volumetric
