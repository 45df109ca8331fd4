// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/model/tracking.h"

/// Distances to solids. Private to tracking/. All three solids are convex, so that the distance of a point to one of
/// them is a convex function of the point, and its minimum over a segment or a triangle is found by halving what is
/// left of it (golden section), without derivatives.
namespace axiometry::tracking {

/// 0 inside.
double distance_to(const Obstacle& obstacle, Vector3 point_mm);

/// The least over the segment from a to b.
double distance_to(const Obstacle& obstacle, Vector3 a_mm, Vector3 b_mm);

/// The least over the triangle: of all beams from a station to a way.
double distance_to(const Obstacle& obstacle, Vector3 station_mm, Vector3 a_mm, Vector3 b_mm);

/// Of a segment from a to b: at a + from·(b − a) to a + to·(b − a).
struct SegmentPart {
  double from = 0.0;
  double to = 0.0;
};

/// Where a segment is nearer than `margin_mm` to the solid (or in it); absent where it never is.
std::optional<SegmentPart> part_nearer_than(const Obstacle& obstacle, Vector3 a_mm, Vector3 b_mm, double margin_mm);

}  // namespace axiometry::tracking
