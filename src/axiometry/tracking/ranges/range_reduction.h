// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/tracking/ranges/range_equations.h"

/// The reduced system: what is left of the normal equations of multilateration when the points are eliminated.
/// Internal to multilaterate().
namespace axiometry::tracking::detail {

struct ReducedSystem {
  std::size_t size = 0;
  std::vector<double> matrix;    ///< U − Σ WᵀV⁻¹W, by rows, symmetric
  std::vector<double> gradient;  ///< g_y − Σ WᵀV⁻¹g_p
  std::vector<double> diagonal;  ///< diagonal of U, by which columns are scaled
  double damping = 0.0;          ///< damping with which it was made
  double chi_squared = 0.0;
  std::size_t weak_points = 0;  ///< points whose beams lie in one plane
  std::size_t first_weak = 0;
  double largest_move_mm = 0.0;  ///< largest move of a point in this pass
};

/// A priori knowledge of free scales: standard uncertainty about 1, or 0.
struct ReductionInput {
  const RangeLayout& layout;
  const RangeWeighting& weighting;
  double scale_prior = 0.0;
  PointChunks chunks;
};

/// The step of the stations' unknowns with which points are moved before they are linearised.
struct ReducedStep {
  std::span<const double> y;
  double damping = 0.0;
  const RangeState& from;
};

/// One pass: moves the points of `state` by the step where there is one (the rest of `state` has been moved already),
/// linearises there and reduces. The normal matrix's diagonal is enlarged by `damping` (Levenberg–Marquardt).
ReducedSystem reduce(const ReductionInput& input, RangeState& state, const std::optional<ReducedStep>& step,
                     double damping);

}  // namespace axiometry::tracking::detail
