// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/plan/run_way.h"

#include "axiometry/tracking/geometry/visibility.h"

namespace axiometry::volumetric {

std::vector<WayPoint> way_of(const CalibrationPlan& plan, const PlannedRun& run) {
  std::vector<WayPoint> way;
  if (run.stops.empty()) return way;
  const TrackingSetup setup = setup_of(plan, run.station, run.tool);
  const auto add_above = [&](Vector3 stop) {
    Vector3 above = stop;
    above.z = plan.machine.travel.highest_mm.z;
    const Vector3 t = setup.tool_offset_mm;
    if (!(above == stop) && !tracking::blocked_because(setup, stop + t, above + t)) way.push_back({above});
  };
  add_above(run.stops.front().axes_mm);
  for (const PlannedStop& stop : run.stops) {
    for (const Vector3& over : stop.over_mm) way.push_back({over});
    way.push_back({stop.axes_mm, true, stop.beam_kept});
  }
  add_above(run.stops.back().axes_mm);
  return way;
}

}  // namespace axiometry::volumetric
