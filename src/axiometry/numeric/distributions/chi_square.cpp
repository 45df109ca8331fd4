// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/distributions/chi_square.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {
namespace {

constexpr double last_term = 1e-17;
constexpr int terms_max = 100'000;

/// x^a e^−x / Γ(a + 1).
double gamma_factor(double a, double x) { return std::exp(a * std::log(x) - x - std::lgamma(a + 1.0)); }

double lower_by_series(double a, double x) {
  double term = 1.0;
  double sum = 1.0;
  for (int n = 1; n < terms_max && term > last_term * sum; ++n) sum += term *= x / (a + n);
  return gamma_factor(a, x) * sum;
}

/// Modified Lentz method.
double upper_by_fraction(double a, double x) {
  constexpr double tiny = 1e-300;
  double b = x + 1.0 - a;
  double c = 1.0 / tiny;
  double d = 1.0 / b;
  double fraction = d;
  for (int n = 1; n < terms_max; ++n) {
    const double step = -n * (n - a);
    b += 2.0;
    d = step * d + b;
    if (std::abs(d) < tiny) d = tiny;
    c = b + step / c;
    if (std::abs(c) < tiny) c = tiny;
    d = 1.0 / d;
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < 1e-16) break;
  }
  return gamma_factor(a, x) * a * fraction;
}

}  // namespace

double chi_square_probability(double x, double degrees_of_freedom) {
  AXIOMETRY_CONTRACT(degrees_of_freedom > 0.0);
  const double a = 0.5 * degrees_of_freedom;
  const double half = 0.5 * x;
  if (!(half > 0.0)) return 0.0;
  if (std::isinf(half)) return 1.0;
  return half < a + 1.0 ? lower_by_series(a, half) : 1.0 - upper_by_fraction(a, half);
}

double chi_square_tail(double x, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0 || !(x > 0.0)) return 1.0;
  if (std::isinf(x)) return 0.0;
  const double half = x / 2.0;
  const bool odd = degrees_of_freedom % 2 == 1;
  double sum = odd ? std::erfc(std::sqrt(half)) : 0.0;
  // Q(ν/2, x/2) = [erfc √(x/2)] + Σ e^{−x/2} (x/2)^a / Γ(a + 1), a = 0, 1, … or ½, 3/2, … below ν/2
  for (double a = odd ? 0.5 : 0.0; a < static_cast<double>(degrees_of_freedom) / 2.0 - 0.25; a += 1.0)
    sum += std::exp(a * std::log(half) - half - std::lgamma(a + 1.0));
  return std::clamp(sum, 0.0, 1.0);
}

double chi_square_quantile(double p, double degrees_of_freedom) {
  AXIOMETRY_CONTRACT(degrees_of_freedom > 0.0 && p > 0.0 && p < 1.0);
  double low = 0.0;
  double high = degrees_of_freedom + 1.0;
  while (chi_square_probability(high, degrees_of_freedom) < p) high *= 2.0;
  for (int step = 0; step < 200 && high - low > 1e-15 * high; ++step) {
    const double middle = 0.5 * (low + high);
    (chi_square_probability(middle, degrees_of_freedom) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace axiometry::numeric
