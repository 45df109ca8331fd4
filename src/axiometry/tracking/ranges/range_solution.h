// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/tracking/ranges/range_gauge.h"
#include "axiometry/tracking/ranges/range_reduction.h"

/// The iteration, the gauge of its result, and whether there is one. Internal to multilaterate().
namespace axiometry::tracking::detail {

/// What about a problem does not change while it is solved.
struct RangeProblem {
  const RangeLayout& layout;
  RangeWeighting weighting;
  double scale_prior = 0.0;  ///< prior of free scales
  bool size_free = false;    ///< no length and no prior tells the size of the solution's unknowns
  std::size_t iterations_most = 50;
  PointChunks chunks;
  std::stop_token stop{};  ///< no iteration begins any more

  ReductionInput input() const { return {layout, weighting, scale_prior, chunks}; }
  GaugeDirections gauge(const RangeState& state) const {
    return gauge_directions(layout, state, weighting.scale_length_mm, size_free);
  }
};

struct RangeIteration {
  ReducedSystem system;  ///< system at the state reached, not damped
  std::size_t iterations = 0;
  bool converged = false;
};

/// Gauss–Newton with one pass over the points for each step; Levenberg–Marquardt damping where a step fails. Converged
/// when no point moves by more than 1e-10 of the mean distance, or χ² no longer changes.
RangeIteration iterate(const RangeProblem& problem, RangeState& state);

/// How stations stand: their largest distance from the plane fitted to all, and from the line.
struct StationSpread {
  double off_plane_mm = 0.0;
  double off_line_mm = 0.0;
};
StationSpread station_spread(std::span<const Vector3> stations_mm);

/// How many directions coplanar stations leave open beyond the gauge: 2, 1 for 4, 5 stations with fixed scale, 4, 3, 2,
/// 1 for 4 to 7 with free scales.
std::size_t coplanar_null_directions(std::size_t stations, bool free_scales);

/// Moves, turns and, with `with_size`, sizes the state onto the nominal points by least squares; mirrors it where that
/// fits better, which no length contradicts. Returns whether it did.
bool align(RangeState& state, std::span<const Vector3> nominal_mm, bool with_size);

}  // namespace axiometry::tracking::detail
