// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/f_distribution.h"

#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {
namespace {

/// ln Γ(x) for x > 0 by Stirling's series, whose first term left out is below 1e-16 from 15 on. That of the C library
/// writes a global variable.
double log_gamma(double x) {
  double shift = 0.0;
  for (; x < 15.0; x += 1.0) shift -= std::log(x);
  const double r = 1.0 / (x * x);
  const double series = (1.0 / 12 - r * (1.0 / 360 - r * (1.0 / 1260 - r * (1.0 / 1680 - r * (1.0 / 1188))))) / x;
  return shift + (x - 0.5) * std::log(x) - x + 0.5 * std::log(2.0 * std::numbers::pi) + series;
}

/// The continued fraction of I_x(a, b) by the modified Lentz method; converges fast for x < (a + 1)/(a + b + 2).
double continued_fraction(double a, double b, double x) {
  constexpr double tiny = 1e-300;
  const auto nonzero = [](double v) { return std::abs(v) < tiny ? tiny : v; };
  double c = 1.0;
  double d = 1.0 / nonzero(1.0 - (a + b) * x / (a + 1.0));
  double fraction = d;
  for (int m = 1; m < 10'000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1.0) * (a + 2 * m));
    d = 1.0 / nonzero(1.0 + even * d);
    c = nonzero(1.0 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1.0));
    d = 1.0 / nonzero(1.0 + odd * d);
    c = nonzero(1.0 + odd / c);
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < 1e-15) break;
  }
  return fraction;
}

/// I_x(a, b) where `y` is 1 − x without cancellation.
double incomplete_beta(double a, double b, double x, double y) {
  if (x <= 0.0) return 0.0;
  if (y <= 0.0) return 1.0;
  const double factor = std::exp(a * std::log(x) + b * std::log(y) + log_gamma(a + b) - log_gamma(a) - log_gamma(b));
  if (x < (a + 1.0) / (a + b + 2.0)) return factor / a * continued_fraction(a, b, x);
  return 1.0 - factor / b * continued_fraction(b, a, y);
}

}  // namespace

double f_tail(double f, RatioDegrees degrees) {
  AXIOMETRY_CONTRACT(degrees.above > 0.0 && degrees.below > 0.0 && f >= 0.0);
  if (std::isinf(f)) return 0.0;
  const double ratio = degrees.above * f / degrees.below;
  return incomplete_beta(0.5 * degrees.below, 0.5 * degrees.above, 1.0 / (1.0 + ratio), ratio / (1.0 + ratio));
}

}  // namespace axiometry::numeric
