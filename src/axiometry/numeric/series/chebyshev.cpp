// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/series/chebyshev.h"

#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {

ChebyshevPoints::ChebyshevPoints(double lower, double upper, std::size_t count) : points_(count) {
  AXIOMETRY_CONTRACT(lower <= upper && count >= 2);
  const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
  for (std::size_t k = 0; k < count; ++k)
    points_[k] = middle + half * std::cos(std::numbers::pi * double(k) / double(count - 1));
}

double ChebyshevPoints::interpolated(std::span<const double> values, double x) const {
  AXIOMETRY_CONTRACT(values.size() == points_.size());
  double above = 0.0, below = 0.0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const double distance = x - points_[k];
    if (distance == 0.0) return values[k];
    const bool at_end = k == 0 || k + 1 == points_.size();
    const double weight = (k % 2 == 0 ? 1.0 : -1.0) * (at_end ? 0.5 : 1.0) / distance;
    above += weight * values[k];
    below += weight;
  }
  return above / below;
}

}  // namespace axiometry::numeric
