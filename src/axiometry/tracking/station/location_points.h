// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Choosing the points of the station location before it is known exactly: a rough station (a steel rule is enough)
/// tells how well any set of points will find it.
namespace axiometry::tracking {

/// How a set of points would find a station.
struct LocationQuality {
  Matrix3 covariance_mm2{};        ///< covariance of the station, with the stated uncertainty of lengths
  Vector3 amplification{};         ///< standard uncertainty of x, y, z per that of one length (µm per µm)
  double condition_refined = 0.0;  ///< condition of the rows [−u, −1], at most 1/ε
  double condition_linear = 0.0;  ///< condition of eq. 14, at most 1/ε: so on a critical surface and below five points
};

/// Needs four points or more, not all at one place.
LocationQuality location_quality(std::span<const Vector3> points_mm, Vector3 station_mm,
                                 const RangingUncertainty& ranging);

struct LocationPlan {
  std::vector<Vector3> points_mm;  ///< positions of the reflector, rounded to 0.001 mm, in the order in which to drive
  LocationQuality quality;
  /// Sentences without full stop: ways on which the beam is lost or the station too near, weak directions.
  std::vector<std::string> remarks;
};

/// `count` (6 to 50) points that the axes can reach and the instrument can see, chosen so that the largest
/// amplification is small and eq. 14 is well conditioned: the best of a few exchange designs from a grid of candidates,
/// the same for the same request. In an order with short ways, straight and in sight of the beam where there are such.
/// Fails on another count, on a travel that is none, when fewer than `count` candidates can be reached and seen,
/// telling what took most of them away, and when no choice finds the station.
Result<LocationPlan> plan_location(const TrackingSetup& setup, std::size_t count);

}  // namespace axiometry::tracking
