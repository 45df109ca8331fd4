// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/point_spread.h"

#include <algorithm>

#include "axiometry/base/contract.h"

namespace axiometry::volumetric {

PointReach reach_of(std::span<const Vector3> points) {
  AXIOMETRY_CONTRACT(!points.empty());
  PointReach reach;
  for (const Vector3& p : points)
    if (norm(p - points.front()) > norm(reach.along_mm)) reach.along_mm = p - points.front();
  if (norm(reach.along_mm) == 0.0) return reach;
  for (const Vector3& p : points)
    reach.beside_mm = std::max(reach.beside_mm, norm(cross(unit(reach.along_mm), p - points.front())));
  return reach;
}

PointSpread point_spread(std::span<const Vector3> points, double apart_mm) {
  const PointReach reach = reach_of(points);
  if (norm(reach.along_mm) <= apart_mm) return PointSpread::point;
  return reach.beside_mm > apart_mm ? PointSpread::plane : PointSpread::line;
}

std::vector<Vector3> seen_offsets(std::vector<Vector3> offsets) {
  if (offsets.empty()) return offsets;
  constexpr double rounding_mm = 1e-6;  // offsets that are on it already stay as they were written
  const Vector3 first = offsets.front(), along = reach_of(offsets).along_mm;
  switch (tool_spread(offsets)) {
    case PointSpread::point: std::ranges::fill(offsets, first); break;
    case PointSpread::line:
      for (Vector3& t : offsets) {
        const Vector3 on_line = first + dot(t - first, unit(along)) * unit(along);
        if (distance(t, on_line) > rounding_mm) t = on_line;
      }
      break;
    case PointSpread::plane: break;
  }
  return offsets;
}

}  // namespace axiometry::volumetric
