// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/tracking/ranges/multilateration.h"

/// What multilaterate() says about a result. Internal to it.
namespace axiometry::tracking::detail {

std::string station_name(const MultilaterationOptions& options, std::size_t j);
std::string point_name(const MultilaterationOptions& options, std::size_t i);

/// "a, b, c and 4 more".
std::string listed(std::span<const std::string> names);

struct FindingInput {
  std::span<const RangeReading> readings;
  const MultilaterationFit& fit;
  const MultilaterationOptions& options;
  std::span<const std::size_t> mirrored_stations;  ///< stations whose mirror image fits the nominal points as well
  bool mirrored = false;                           ///< the result had to be mirrored onto the nominal points
  std::size_t points_seen_by_three = 0;
  double sigma_mm = 0.0;     ///< σ of a length at the mean distance
  double distance_mm = 0.0;  ///< mean
  std::size_t weakest_station = 0;
};
std::vector<Finding> multilateration_findings(const FindingInput& input);

}  // namespace axiometry::tracking::detail
