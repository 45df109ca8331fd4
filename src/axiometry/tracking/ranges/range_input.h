// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/tracking/ranges/multilateration.h"
#include "axiometry/tracking/ranges/range_start.h"

/// What multilaterate() asks of its input before it computes anything, and the starts of stations. Internal to it.
namespace axiometry::tracking::detail {

struct RangeInput {
  std::span<const Vector3> nominal_mm;
  std::size_t stations = 0;
  std::span<const RangeReading> readings;
  const MultilaterationOptions& options;
};

struct RangeCounts {
  std::size_t segments = 0;  ///< segments of all stations
  std::size_t points_seen_by_three = 0;
};

/// Numbers that are finite, points and stations that exist and are seen, by enough of each other.
Result<RangeCounts> check_ranges(const RangeInput& input);

/// Enough equations for all unknowns. Fails with the least number of points.
Result<void> check_counts(const RangeInput& input, MultilaterationRank& rank, std::size_t segments);

struct RangeStarts {
  std::vector<Vector3> stations;
  std::vector<std::vector<double>> dead;  ///< dead path per station and segment
  std::vector<std::size_t> segments;      ///< segment per reading
  std::vector<RangeBreak> breaks;
  std::vector<std::size_t> mirrored;  ///< stations whose mirror image fits as well
};

/// Fails on lengths that contradict the nominal points.
Result<RangeStarts> start_all(const RangeInput& input, bool find_breaks);

/// A step in the residuals of a station that is far above their scatter. Needs residuals of all readings.
std::optional<RangeBreak> find_residual_step(const RangeInput& input, std::span<const double> residuals_mm,
                                             std::span<const std::size_t> segments);

}  // namespace axiometry::tracking::detail
