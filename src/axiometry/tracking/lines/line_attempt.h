// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/tracking/lines/seven_lines.h"

/// One direction from a station, judged. Private to tracking/.
namespace axiometry::tracking {

/// How far a direction came; the reason of the one that came farthest is told.
enum class Stage { off_travels, past_travels, elevation, incidence, too_short, usable };

struct Attempt {
  UsableInterval interval;
  Stage stage = Stage::usable;
  std::string reason{};  ///< why it is not usable
};

/// The directions of a line of the seven, one per octant; none where the rule gives none, or for other ids.
std::vector<Vector3> line_directions(const TrackingSetup& setup, std::string_view id, DiagonalRule rule);

Attempt attempt_line(const TrackingSetup& setup, std::string_view id, Vector3 direction);

/// Angle between the beam along a line and the axis of the reflector, °.
double incidence_deg(Vector3 direction, Vector3 reflector_axis);

}  // namespace axiometry::tracking
