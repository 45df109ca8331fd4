// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Choosing the points of the station location before it is known exactly: a rough station (a steel rule is enough)
/// tells how well any set of points will find it.
namespace axiometry::tracking {

/// How a set of points would find a station.
struct LocationQuality {
  Matrix3 covariance_mm2{};        ///< of the station, with the stated uncertainty of lengths
  Vector3 amplification{};         ///< standard uncertainty of x, y, z per that of one length (µm per µm)
  double condition_refined = 0.0;  ///< of the rows [−u, −1]
  double condition_linear = 0.0;   ///< of eq. 14; infinite on a critical surface
};

LocationQuality location_quality(std::span<const Vector3> points_mm, Vector3 station_mm,
                                 const RangingUncertainty& ranging);

/// `count` (6 or more) points that the axes can reach and the instrument can see, chosen so that the largest
/// amplification is small and eq. 14 is well conditioned: the best exchange design from a grid of candidates, the same
/// for the same request. In an order with short and safe ways between them. Points are where the reflector stands.
/// Fails when fewer than `count` candidates can be reached and seen, telling what took most of them away, and when no
/// choice finds the station.
struct LocationPlan {
  std::vector<Vector3> points_mm;  ///< of the reflector, rounded to 0.001 mm
  LocationQuality quality;
};
Result<LocationPlan> plan_location(const TrackingSetup& setup, std::size_t count);

}  // namespace axiometry::tracking
