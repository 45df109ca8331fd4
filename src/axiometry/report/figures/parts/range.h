// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// Private to this folder.
namespace axiometry::report::plot {

/// From the least to the largest of what was seen; before anything was, low > high.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void see(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  bool any() const { return low <= high; }
  double size() const { return high - low; }
  double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
  bool has(double x) const { return x >= low && x <= high; }
};

}  // namespace axiometry::report::plot
