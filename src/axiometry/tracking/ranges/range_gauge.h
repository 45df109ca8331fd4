// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/tracking/ranges/range_reduction.h"

/// Solving the reduced system within its gauge, and what it says about itself. Internal to multilaterate().
namespace axiometry::tracking::detail {

/// Directions of the stations' unknowns that no length sees: translations, rotations about the stations' mean and, with
/// scales of which nothing is known, the size. One vector each.
using GaugeDirections = std::vector<std::vector<double>>;
GaugeDirections gauge_directions(const RangeLayout& layout, const RangeState& state, double scale_length_mm,
                                 bool with_size);

/// −S⁺g: the step that is orthogonal to the gauge in scaled unknowns.
std::vector<double> reduced_step(const ReducedSystem& system, const GaugeDirections& gauge);

/// S⁺, by rows: the covariance of the stations' unknowns in the gauge of reduced_step().
std::vector<double> reduced_covariance(const ReducedSystem& system, const GaugeDirections& gauge);

struct ReducedRank {
  std::size_t null_directions = 0;  ///< eigenvalues below 1e-12 of the system scaled to a unit diagonal of U
  double condition = 0.0;           ///< largest over smallest eigenvalue beyond the gauge; infinite below full rank
  double weakest_mm = 0.0;          ///< u, along the direction known worst, of the station that it moves most
  std::size_t weakest_station = 0;
};

/// Rounding in S comes from the difference of U and Σ WᵀV⁻¹W, a few units of 1e-16 for each scaled entry; directions
/// that a geometry leaves open show eigenvalues of 1e-14 and less, set-ups of as few points as can be 1e-11.
ReducedRank reduced_rank(const ReducedSystem& system, const GaugeDirections& gauge, const RangeLayout& layout);

}  // namespace axiometry::tracking::detail
