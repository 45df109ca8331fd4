// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace axiometry::numeric {

/// Mean and empirical standard deviation of a sample.
struct Moments {
  std::size_t count = 0;            ///< values that are present
  double mean = 0.0;                ///< 0 when count is 0
  double standard_deviation = 0.0;  ///< divisor count − 1; 0 when count is below 2
};

/// Moments of the values that are not NaN, in two passes. The second pass works on differences from
/// the mean, so an offset of size c costs about c·2⁻⁵² of absolute error and nothing more.
inline Moments moments(std::span<const double> values) {
  Moments result;
  double sum = 0.0;
  for (double x : values) {
    if (std::isnan(x)) continue;
    sum += x;
    ++result.count;
  }
  if (result.count == 0) return result;
  result.mean = sum / static_cast<double>(result.count);
  if (result.count < 2) return result;
  double squares = 0.0;
  for (double x : values) {
    if (std::isnan(x)) continue;
    const double difference = x - result.mean;
    squares += difference * difference;
  }
  result.standard_deviation = std::sqrt(squares / static_cast<double>(result.count - 1));
  return result;
}

}  // namespace axiometry::numeric
