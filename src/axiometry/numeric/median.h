// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

/// Medians of a sample, which must not be empty.
namespace axiometry::numeric {

/// Of an even number the mean of the middle two. Leaves the sample in another order.
inline double median_of(std::span<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::ranges::nth_element(x, middle);
  if (x.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(x.begin(), middle));
}

inline double median(std::vector<double> x) { return median_of(x); }

/// Of an even number the upper one of the middle two.
inline double upper_median(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::ranges::nth_element(x, middle);
  return *middle;
}

}  // namespace axiometry::numeric
