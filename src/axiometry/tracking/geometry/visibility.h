// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// What the reflector may come near to and what the beam can see. All points are of the reflector's centre, in its
/// coordinates, unless a name says that the axes stand there; the moving body is that centre with the distances that it
/// must keep: TrackerLimits::safe_radius_mm from the station, obstacle_margin_mm from obstacles. What carries the
/// reflector (tool, spindle) is not known: obstacles that it could touch are to be given larger.
///
/// Distances of segments to solids are minima of convex functions, found to 1e-9 of the length of the segment; nothing
/// is sampled. Derivation: docs/theory/seven-lines.md.
namespace axiometry::tracking {

/// What the centre of the reflector keeps from obstacles: half the width of a usual holder of a cat's eye, and what a
/// steel rule errs (a setting of this program, no constant of nature).
inline constexpr double obstacle_margin_mm = 50.0;

/// What the middle of the beam keeps from obstacles: its radius and some room.
inline constexpr double beam_margin_mm = 5.0;

/// Places within this of a limit are on it: programs are written to 0.001 mm.
inline constexpr double limit_slack_mm = 1e-6;
/// Likewise of angles.
inline constexpr double limit_slack_deg = 1e-7;

/// Least distance of a point to the segment from a to b.
double distance_to_segment(Vector3 point_mm, Vector3 a_mm, Vector3 b_mm);

/// Whether a segment meets a solid that is grown by `margin_mm` on all sides (edges and corners become round).
bool meets(const Obstacle& obstacle, Vector3 a_mm, Vector3 b_mm, double margin_mm);

/// Why the reflector cannot be measured here: range, elevation, incidence, an obstacle before it. Absent when it can.
std::optional<std::string> hidden_because(const TrackingSetup& setup, Vector3 reflector_mm);

/// Why the beam is lost somewhere on the straight way from a to b: the limits at their extremes on that way, and
/// obstacles in the triangle of station, a and b. Absent when it is kept.
std::optional<std::string> beam_lost_because(const TrackingSetup& setup, Vector3 from_mm, Vector3 to_mm);

/// Why the reflector may not be driven straight from a to b: the travels, the sphere of the station, an obstacle.
/// Absent when it may.
std::optional<std::string> blocked_because(const TrackingSetup& setup, Vector3 from_mm, Vector3 to_mm);

/// Places of the axes between `from` and `to` (both left out), over which one can drive without coming too near to
/// anything; where possible the beam is kept in sight all the way: straight, else over a higher plane, else around by
/// the shortest way on a coarse grid; a way that loses the beam only when none keeps it. The same for the same set-up.
/// Fails when there is no such way, telling what is in the way of the straight one.
struct Transfer {
  std::vector<Vector3> over_mm;
  bool beam_kept = true;
};
Result<Transfer> safe_transfer(const TrackingSetup& setup, Vector3 from_axes_mm, Vector3 to_axes_mm);

}  // namespace axiometry::tracking
