// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace axiometry::numeric {

/// Trend of a curve over m places: one or two orthonormal columns, one after the other, a constant and a straight line.
std::vector<double> trend_columns(std::span<const double> places, std::size_t terms);

/// Orthonormal basis of a curve over m places, in a time that grows with m³: the trend, then beside it the principal
/// axes of the correlation of Matérn, ν = 5/2, of one length.
struct CurveAxes {
  /// Contract: places ascend, at least `terms` of them; terms 1 or 2.
  CurveAxes(std::span<const double> places, std::size_t terms, double length);

  std::vector<double> columns;  ///< m × m, one basis vector after the other
  std::vector<double> smooth;   ///< d_k, the variance along each; 0 for the trend

  /// Coordinates of values in this basis.
  std::vector<double> coordinates(std::span<const double> values) const;
};

}  // namespace axiometry::numeric
