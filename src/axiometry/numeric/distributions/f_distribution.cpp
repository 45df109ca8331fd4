// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/distributions/f_distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::numeric {
namespace {

/// ln Γ(x) for x > 0 by Stirling's series, whose first term left out is below 3e-16 from 15 on. That of the C library
/// writes a global variable.
double log_gamma(double x) {
  double shift = 0.0;
  for (; x < 15.0; x += 1.0) shift -= std::log(x);
  const double r = 1.0 / (x * x);
  const double series = (1.0 / 12 - r * (1.0 / 360 - r * (1.0 / 1260 - r * (1.0 / 1680 - r * (1.0 / 1188))))) / x;
  return shift + (x - 0.5) * std::log(x) - x + 0.5 * std::log(2.0 * std::numbers::pi) + series;
}

/// I_x(a, b) where `y` is 1 − x without cancellation.
double incomplete_beta(double a, double b, double x, double y) {
  if (x <= 0.0) return 0.0;
  if (y <= 0.0) return 1.0;
  const double factor = std::exp(a * std::log(x) + b * std::log(y) + log_gamma(a + b) - log_gamma(a) - log_gamma(b));
  if (x < (a + 1.0) / (a + b + 2.0)) return factor / a * beta_fraction(a, b, x);
  return 1.0 - factor / b * beta_fraction(b, a, y);
}

}  // namespace

double f_tail(double f, RatioDegrees degrees) {
  AXIOMETRY_CONTRACT(degrees.above > 0.0 && degrees.below > 0.0 && f >= 0.0);
  if (std::isinf(f)) return 0.0;
  const double ratio = degrees.above * f / degrees.below;
  return incomplete_beta(0.5 * degrees.below, 0.5 * degrees.above, 1.0 / (1.0 + ratio), ratio / (1.0 + ratio));
}

bool f_tail_is_above(double level, double f, RatioDegrees degrees) {
  constexpr double slack = 1.0 + 1e-6;  // more than the rounding of either side
  constexpr double terms_at_most = 50.0;
  AXIOMETRY_CONTRACT(degrees.above > 0.0 && degrees.below > 0.0 && f >= 0.0);
  const double ratio = degrees.above * f / degrees.below, b = 0.5 * degrees.below;
  const double y = ratio / (1.0 + ratio);
  const double wanted = slack * level * std::exp(b * std::log1p(ratio));  // of the sum; NaN or infinite: never reached
  double sum = 0.0, term = 1.0;
  for (double j = 0.0; j + 1.0 <= std::min(0.5 * degrees.above, terms_at_most); j += 1.0) {
    sum += term;
    if (sum > wanted) return true;
    term *= (b + j) / (j + 1.0) * y;
  }
  return false;
}

}  // namespace axiometry::numeric
