// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/base/vector3.h"

/// How points lie: what a rotation about a line moves only where one of them stands beside that line.
namespace axiometry::volumetric {

enum class PointSpread { point, line, plane };

/// Of points: the farthest from the first, and how far one lies from the line through both.
struct PointReach {
  Vector3 along_mm;        ///< vector from the first to the farthest
  double beside_mm = 0.0;  ///< distance of the one farthest from the line; 0 where all are one point
};

/// Contract: at least one.
PointReach reach_of(std::span<const Vector3> points_mm);

/// Points within `apart_mm` of a point, or of a line, are on it.
PointSpread point_spread(std::span<const Vector3> points_mm, double apart_mm);

/// A rotation that moves none of the tool points by more than this is not seen: what is left of the lever, as the
/// offsets of tools on the spindle's axis when they are measured, would make it rotations of milliradians with nothing
/// behind.
inline constexpr double tools_apart_mm = 1.0;

inline PointSpread tool_spread(std::span<const Vector3> offsets_mm) { return point_spread(offsets_mm, tools_apart_mm); }

/// Offsets of tools as they count: those that lie within 1 mm of a point or a line are moved on to it, so that what
/// these tools do not tell is not told. Others are as they are.
std::vector<Vector3> seen_offsets(std::vector<Vector3> offsets_mm);

}  // namespace axiometry::volumetric
