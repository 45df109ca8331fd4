// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/distributions/normal_and_student_t.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {
namespace {

constexpr double normal_from = 1e8;  // degrees of freedom

/// Γ(a + 1/2)/Γ(a). Beyond a = 30 the asymptotic series; its first term left out is below 2e-17 there.
double gamma_ratio(double a) {
  if (a < 30.0) return std::tgamma(a + 0.5) / std::tgamma(a);
  const double r = 1.0 / a;
  constexpr double c[] = {1.0,
                          -1.0 / 8,
                          1.0 / 128,
                          5.0 / 1024,
                          -21.0 / 32768,
                          -399.0 / 262144,
                          869.0 / 4194304,
                          39325.0 / 33554432,
                          -334477.0 / 2147483648.0};
  double series = 0.0;
  for (std::size_t k = std::size(c); k-- > 0;) series = series * r + c[k];
  return std::sqrt(a) * series;
}

/// P(T > t) and P(0 < T < t) for t ≥ 0: whichever the other would be cancelled from is computed directly.
struct Sides {
  double tail = 0.5;
  double centre = 0.0;
};

Sides student_sides(double t, double nu) {
  if (t == 0.0) return {};
  if (std::isinf(t)) return {0.0, 0.5};
  const double a = nu / 2;
  const double ratio = t / std::sqrt(nu);  // its square may overflow where the tail does not vanish
  const double log_x = ratio > 1e100 ? -2 * std::log(ratio) : -std::log1p(ratio * ratio);
  const double y = ratio > 1e100 ? 1.0 : ratio * ratio / (1.0 + ratio * ratio);  // 1 − x
  const double factor = std::exp(a * log_x) * std::sqrt(y) * gamma_ratio(a) / std::sqrt(std::numbers::pi);
  if (1.0 - y < (a + 1.0) / (a + 2.5)) {
    const double tail = 0.5 * factor / a * beta_fraction(a, 0.5, std::exp(log_x));
    return {tail, 0.5 - tail};
  }
  const double centre = factor * beta_fraction(0.5, a, y);
  return {0.5 - centre, centre};
}

Sides normal_sides(double z) {
  const double x = z / std::numbers::sqrt2;
  return {0.5 * std::erfc(x), 0.5 * std::erf(x)};
}

double student_density(double t, double nu) {
  const double ratio = t / std::sqrt(nu);
  const double log_x = ratio > 1e100 ? -2 * std::log(ratio) : -std::log1p(ratio * ratio);
  return gamma_ratio(nu / 2) / std::sqrt(nu * std::numbers::pi) * std::exp((nu + 1) / 2 * log_x);
}

double normal_density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }

/// The t > 0 at which the tail is q < 1/2 (or the centre 1/2 − q, where q is the larger): Newton steps on log against
/// log, where both functions are concave and nearly straight, kept between bounds that close in.
template <typename SidesOf, typename DensityOf>
double solve(double q, double centre, double start, SidesOf sides_of, DensityOf density_of) {
  double lower = -745.0, upper = 709.0;  // logarithms of all positive doubles
  double s = std::log(start);
  const bool by_tail = q < 0.25;
  for (int i = 0; i < 200; ++i) {
    const double t = std::exp(s);
    const Sides sides = sides_of(t);
    const double value = by_tail ? sides.tail : sides.centre;
    const double wanted = by_tail ? q : centre;
    const bool too_far = by_tail ? value < wanted : value > wanted;
    (too_far ? upper : lower) = s;
    double next = 0.5 * (lower + upper);
    if (value > 0.0) {
      const double slope = (by_tail ? -1.0 : 1.0) * t * density_of(t) / value;
      const double newton = s - std::log(value / wanted) / slope;
      if (newton > lower && newton < upper) next = newton;
      if (std::abs(newton - s) < 4e-16 * std::max(1.0, std::abs(s))) break;
    }
    if (next == s) break;
    s = next;
  }
  return std::exp(s);
}

template <typename SidesOf, typename DensityOf>
double quantile(double p, double start, SidesOf sides_of, DensityOf density_of) {
  AXIOMETRY_CONTRACT(p > 0.0 && p < 1.0);
  if (p == 0.5) return 0.0;
  const double t = solve(std::min(p, 1.0 - p), std::abs(p - 0.5), start, sides_of, density_of);
  return p < 0.5 ? -t : t;
}

}  // namespace

double beta_fraction(double a, double b, double x) {
  constexpr double tiny = 1e-300;
  const auto away_from_zero = [](double v) { return std::abs(v) < tiny ? tiny : v; };
  double c = 1.0;
  double d = 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0));
  double fraction = d;
  for (int m = 1; m < 100'000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1.0) * (a + 2 * m));
    d = 1.0 / away_from_zero(1.0 + even * d);
    c = away_from_zero(1.0 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1.0));
    d = 1.0 / away_from_zero(1.0 + odd * d);
    c = away_from_zero(1.0 + odd / c);
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < 1e-16) break;
  }
  return fraction;
}

double normal_probability(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double normal_quantile(double p) { return quantile(p, 1.0, normal_sides, normal_density); }

double student_t_probability(double t, double nu) {
  AXIOMETRY_CONTRACT(nu > 0.0);
  if (nu > normal_from) return normal_probability(t);
  const Sides sides = student_sides(std::abs(t), nu);
  return t < 0.0 ? sides.tail : 0.5 + sides.centre;
}

double student_t_quantile(double p, double nu) {
  AXIOMETRY_CONTRACT(nu > 0.0);
  if (nu > normal_from) return normal_quantile(p);
  return quantile(
      p, 1.0, [nu](double t) { return student_sides(t, nu); }, [nu](double t) { return student_density(t, nu); });
}

}  // namespace axiometry::numeric
