// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace axiometry::numeric {

/// Functions told from their values at Chebyshev's points of an interval, by the barycentric formula, which does not
/// magnify rounding (Berrut & Trefethen, Barycentric Lagrange interpolation, SIAM Review 46, 2004, 5.4 and 6).
///
/// A function that is analytic within the ellipse of foci lower and upper whose half axes add up to ρ times half the
/// interval, and there at most M, is off by at most 4 M ρ^{1−n}/(ρ − 1) with n points.
class ChebyshevPoints {
 public:
  /// Contract: lower ≤ upper, at least two points.
  ChebyshevPoints(double lower, double upper, std::size_t count);

  std::span<const double> points() const { return points_; }  ///< descending

  /// What `values` at the points are at x, which lies in the interval but for rounding.
  double interpolated(std::span<const double> values, double x) const;

 private:
  std::vector<double> points_;
};

}  // namespace axiometry::numeric
