// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/chi_squared.h"

#include <algorithm>
#include <cmath>

namespace axiometry::tracking {

double chi_squared_tail(double x, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0 || !(x > 0.0)) return 1.0;
  const double half = x / 2.0;
  const bool odd = degrees_of_freedom % 2 == 1;
  double sum = odd ? std::erfc(std::sqrt(half)) : 0.0;
  // Q(ν/2, x/2) = [erfc √(x/2)] + Σ e^{−x/2} (x/2)^a / Γ(a + 1), a = 0, 1, … or ½, 3/2, … below ν/2
  for (double a = odd ? 0.5 : 0.0; a < static_cast<double>(degrees_of_freedom) / 2.0 - 0.25; a += 1.0)
    sum += std::exp(a * std::log(half) - half - std::lgamma(a + 1.0));
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace axiometry::tracking
