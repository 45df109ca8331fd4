// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// A planned line as the station sees it.
namespace axiometry::tracking {

inline constexpr double deg_per_rad = 180.0 / std::numbers::pi;

struct LineGeometry {
  Vector3 direction;                 ///< unit vector of the reflector, where position grows
  Position foot;                     ///< point of the line that is next to the station
  double miss_mm = 0.0;              ///< distance of the station from the line
  std::vector<double> distances_mm;  ///< d(q_i) = |q_i + t − s| of each target
  std::vector<double> cosines;       ///< κ_i = ∂d/∂P at each target, signed
  double angle_most_deg = 0.0;       ///< largest angle between beam and line, over the targets
};

/// Fails on a line not stated in space, on a target within 1 mm of the station, on a line that runs past the station
/// (κ changes its sign between the targets), and where a beam stands at more than 60° to the line: it then measures
/// straightness rather than position.
Result<LineGeometry> line_geometry(const TrackingSetup& setup, const TrackingLine& line);

}  // namespace axiometry::tracking
