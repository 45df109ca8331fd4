// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// What the reflector may come near to and what the beam can see. All points are of the reflector's centre.
namespace axiometry::tracking {

/// Least distance of a point to the segment from a to b.
double distance_to_segment(Vector3 point_mm, Vector3 a_mm, Vector3 b_mm);

/// Whether a segment meets a solid that is grown by `margin_mm` on all sides.
bool meets(const Obstacle& obstacle, Vector3 a_mm, Vector3 b_mm, double margin_mm);

/// Why the reflector cannot be measured here: range, elevation, incidence, an obstacle before it. Absent when it can.
std::optional<std::string> hidden_because(const TrackingSetup& setup, Vector3 reflector_mm);

/// Why the axes may not drive straight from a to b: the sphere of the station, an obstacle, the travels. Absent when
/// they may.
std::optional<std::string> blocked_because(const TrackingSetup& setup, Vector3 from_mm, Vector3 to_mm);

/// Places of the axes between `from` and `to` (both left out), over which one can drive without coming too near to
/// anything; where possible the beam is kept in sight all the way. Fails when there is no such way.
struct Transfer {
  std::vector<Vector3> over_mm;
  bool beam_kept = true;
};
Result<Transfer> safe_transfer(const TrackingSetup& setup, Vector3 from_axes_mm, Vector3 to_axes_mm);

}  // namespace axiometry::tracking
