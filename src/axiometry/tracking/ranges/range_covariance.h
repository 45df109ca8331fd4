// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/tracking/ranges/range_equations.h"

/// Covariances under inner constraints over the points, and residuals. Internal to multilaterate().
namespace axiometry::tracking::detail {

struct RangeCovarianceInput {
  const RangeLayout& layout;
  const RangeState& state;
  const RangeWeighting& weighting;
  std::span<const double> reduced;  ///< reduced_covariance()
  bool with_size = false;           ///< whether the gauge of the result has the size in it
  bool per_point = true;            ///< also of points and of residuals
  PointChunks chunks;
};

/// Without the factor χ²/ν.
struct RangeCovariances {
  std::vector<Matrix3> points;
  std::vector<Matrix3> stations;
  std::vector<double> dead_sigmas;
  std::vector<double> scale_sigmas;  ///< 0 where κ is fixed
  std::vector<double> residuals;     ///< residual per reading as given
  std::vector<double> normalised;    ///< residual by its standard deviation; empty without `per_point`
};

RangeCovariances range_covariances(const RangeCovarianceInput& input);

}  // namespace axiometry::tracking::detail
