// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "axiometry/numeric/distributions/chi_square.h"

namespace axiometry::numeric {

/// What a standard deviation may be of what was found with so many degrees of freedom: √(ν/χ²_ν), in equally likely
/// steps. 1 without any.
class PossibleShares {
 public:
  explicit PossibleShares(double freedom) {
    if (!(freedom > 0.0)) return;
    for (std::size_t k = 0; k < steps; ++k)
      shares_[k] = std::sqrt(freedom / chi_square_quantile((static_cast<double>(k) + 0.5) / double(steps), freedom));
  }

  /// Of a uniform number from (0, 1).
  double operator()(double p) const {
    return shares_[std::min(steps - 1, static_cast<std::size_t>(p * static_cast<double>(steps)))];
  }

 private:
  static constexpr std::size_t steps = 200;
  std::vector<double> shares_ = std::vector<double>(steps, 1.0);
};

}  // namespace axiometry::numeric
