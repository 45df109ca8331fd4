// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/plan/calibration_plan.h"

namespace axiometry::volumetric {

std::vector<Visit> visits_of(const CalibrationPlan& plan) {
  std::vector<Visit> visits;
  for (const PlannedRun& run : plan.runs)
    for (const PlannedStop& stop : run.stops) visits.push_back({run.station, run.tool, stop.axes_mm});
  return visits;
}

TrackingSetup setup_of(const CalibrationPlan& plan, std::size_t station, std::size_t tool) {
  return {plan.machine.travel,
          plan.machine.tools[tool].offset_mm,
          {plan.machine.stations[station].at_mm, {}},
          plan.limits,
          plan.machine.ranging,
          plan.obstacles};
}

}  // namespace axiometry::volumetric
