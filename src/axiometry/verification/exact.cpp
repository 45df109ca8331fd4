// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/exact.h"

#include <fmt/format.h>

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "axiometry/base/contract.h"

namespace axiometry::verification {
namespace {

constexpr int exponent_limit = 120;
constexpr double number_limit = 1e30;

const Integer& one() { return power_of_ten(places); }

Integer divided_down(const Integer& a, const Integer& b) {
  Integer quotient = a / b;
  const bool inexact = quotient * b != a;
  if (inexact && ((a < 0) != (b < 0))) --quotient;
  return quotient;
}

Integer divided_up(const Integer& a, const Integer& b) {
  Integer quotient = divided_down(a, b);
  if (quotient * b != a) ++quotient;
  return quotient;
}

/// In units of 10⁻⁴⁰, rounded down and up.
Interval scaled(const Integer& digits, int exponent) {
  const int shift = exponent + places;
  if (shift >= 0) {
    const Integer all = digits * power_of_ten(std::min(shift, exponent_limit));
    return {all, all};
  }
  if (shift < -exponent_limit) return digits < 0 ? Interval(-1, 0) : Interval(0, digits > 0 ? 1 : 0);
  const Integer& divisor = power_of_ten(-shift);
  return {divided_down(digits, divisor), divided_up(digits, divisor)};
}

}  // namespace

const Integer& power_of_ten(int exponent) {
  static const auto powers = [] {
    std::array<Integer, exponent_limit + 1> all;
    all[0] = 1;
    for (std::size_t k = 1; k < all.size(); ++k) all[k] = all[k - 1] * 10;
    return all;
  }();
  AXIOMETRY_CONTRACT(exponent >= 0 && exponent <= exponent_limit);
  return powers[static_cast<std::size_t>(exponent)];
}

std::optional<Decimal> decimal_of(std::string_view text) {
  constexpr std::string_view true_minus = "\u2212";
  const bool negative = text.starts_with('-') || text.starts_with(true_minus);
  if (text.starts_with('-')) text.remove_prefix(1);
  if (text.starts_with(true_minus)) text.remove_prefix(true_minus.size());
  Decimal decimal;
  std::size_t digits = 0;
  std::size_t significant = 0;
  std::uint64_t head = 0;  // up to eighteen digits at a time
  std::size_t pending = 0;
  const auto flush = [&] {
    decimal.digits = decimal.digits * power_of_ten(static_cast<int>(pending)) + head;
    head = 0;
    pending = 0;
  };
  bool after_mark = false;
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if ((c == '.' || c == ',') && !after_mark) {
      after_mark = true;
      continue;
    }
    if (c < '0' || c > '9') break;
    ++digits;
    if (significant > 0 || c != '0') ++significant;
    if (significant > 100 || digits > 300) return std::nullopt;
    head = head * 10 + static_cast<std::uint64_t>(c - '0');
    if (++pending == 18) flush();
    if (after_mark) --decimal.exponent;
  }
  flush();
  if (digits == 0) return std::nullopt;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::string_view rest = text.substr(at + 1);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    int exponent = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), exponent);
    if (error != std::errc{} || end != rest.data() + rest.size()) return std::nullopt;
    if (exponent < -400 || exponent > 400) return std::nullopt;
    decimal.exponent += exponent;
    at = text.size();
  }
  if (at != text.size()) return std::nullopt;
  if (decimal.digits != 0 && static_cast<int>(significant) + decimal.exponent > 31) return std::nullopt;
  if (decimal.digits == 0) decimal.exponent = std::min(decimal.exponent, 0);
  if (negative) decimal.digits = -decimal.digits;
  return decimal;
}

Interval::Interval(int whole) : lower_(one() * whole), upper_(lower_) {}

Interval::Interval(Integer lower, Integer upper) : lower_(std::move(lower)), upper_(std::move(upper)) {}

Interval Interval::of(const Decimal& decimal) { return scaled(decimal.digits, decimal.exponent); }

Interval Interval::of(double x) {
  if (!(std::abs(x) <= number_limit)) throw std::range_error("a number beyond 1e30");
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x);
  return of(*decimal_of(std::string_view(buffer, end)));
}

Interval Interval::ratio(const Integer& numerator, const Integer& denominator) {
  const Integer all = numerator * one();
  return {divided_down(all, denominator), divided_up(all, denominator)};
}

Interval Interval::root_of_squares(const Integer& numerator, const Integer& denominator) {
  const Integer down = divided_down(numerator, denominator);
  Integer below = sqrt(down);
  Integer above = below;
  if (below * below * denominator != numerator) ++above;
  return {std::move(below), std::move(above)};
}

Interval operator+(const Interval& a, const Interval& b) { return {a.lower_ + b.lower_, a.upper_ + b.upper_}; }

Interval operator-(const Interval& a, const Interval& b) { return {a.lower_ - b.upper_, a.upper_ - b.lower_}; }

Interval operator*(const Interval& a, const Interval& b) {
  const std::array<Integer, 4> products = {a.lower_ * b.lower_, a.lower_ * b.upper_, a.upper_ * b.lower_,
                                           a.upper_ * b.upper_};
  const auto [least, most] = std::ranges::minmax_element(products);
  return {divided_down(*least, one()), divided_up(*most, one())};
}

Interval operator/(const Interval& a, const Interval& b) {
  if (b.lower_ <= 0 && b.upper_ >= 0) throw std::domain_error("division by an interval that holds zero");
  std::array<Integer, 4> down;
  std::array<Integer, 4> up;
  std::size_t k = 0;
  for (const Integer* numerator : {&a.lower_, &a.upper_})
    for (const Integer* denominator : {&b.lower_, &b.upper_}) {
      const Integer all = *numerator * one();
      down[k] = divided_down(all, *denominator);
      up[k++] = divided_up(all, *denominator);
    }
  return {*std::ranges::min_element(down), *std::ranges::max_element(up)};
}

Interval magnitude(const Interval& a) {
  if (a.lower() >= 0) return a;
  if (a.upper() <= 0) return {-a.upper(), -a.lower()};
  return {0, std::max(Integer(-a.lower()), a.upper())};
}

Interval root(const Interval& a) {
  const auto of_end = [](const Integer& end) {
    return Interval::root_of_squares(end > 0 ? Integer(end * one()) : Integer(0), 1);
  };
  return {of_end(a.lower()).lower(), of_end(a.upper()).upper()};
}

Interval larger(const Interval& a, const Interval& b) {
  return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}

Interval smaller(const Interval& a, const Interval& b) {
  return {std::min(a.lower(), b.lower()), std::min(a.upper(), b.upper())};
}

bool surely_at_most(const Interval& a, const Interval& b) { return a.upper() <= b.lower(); }

bool possibly_at_most(const Interval& a, const Interval& b) { return a.lower() <= b.upper(); }

bool within(const Interval& a, const Interval& b, const Interval& distance) {
  return magnitude(a - b).lower() <= distance.upper();
}

std::string shown(const Interval& a, int digits) {
  // For messages alone: the nearest double shows the digits that people look at.
  const Integer middle = (a.lower() + a.upper()) / 2;
  const double value = (middle / power_of_ten(places - 25)).convert_to<double>() * 1e-25;
  return fmt::format("{:.{}g}", value, digits);
}

namespace {

/// e^t for 0 ≤ t ≤ 64: all terms are positive; the rest after a term below half the one before is no larger than it.
Interval exponential(const Interval& t) {
  Interval sum = 1;
  Interval term = 1;
  for (int k = 1; k < 400; ++k) {
    term = term * t / Interval(k);
    sum = sum + term;
    if (k > 128 && term.upper() <= 4) break;
  }
  return {sum.lower(), sum.upper() + 2 * term.upper() + 2};
}

const Interval& root_of_two_pi() {
  static const Interval value = root(Interval::of(*decimal_of("6.28318530717958647692528676655900576839433879875")) +
                                     Interval(Integer(0), Integer(1)));
  return value;
}

/// Φ(z) − 1/2 = φ(z) Σ z^(2k+1) / (1·3·…·(2k+1)), 0 ≤ z ≤ 9.
Interval central_probability(const Interval& z) {
  const Interval square = z * z;
  Interval sum = z;
  Interval term = z;
  for (int k = 1; k < 600; ++k) {
    term = term * square / Interval(2 * k + 1);
    sum = sum + term;
    if (2 * k + 1 > 2 * 81 && term.upper() <= 4) break;  // from here on each term is at most half the one before
  }
  sum = {sum.lower(), sum.upper() + 2 * term.upper() + 2};
  return sum / (root_of_two_pi() * exponential(square / Interval(2)));
}

}  // namespace

Interval normal_distribution(const Interval& z) {
  const Interval half = Interval(1) / Interval(2);
  const Interval far = 9;  // beyond, the tail is below 2e-19
  const Interval tail = {0, 2 * power_of_ten(places - 19)};
  const auto of_end = [&](const Integer& end) -> Interval {
    const bool negative = end < 0;
    const Integer size = negative ? Integer(-end) : end;
    const Interval above = size >= far.lower() ? Interval(1) - half - tail : central_probability({size, size});
    return negative ? half - above : half + above;
  };
  const Interval below = of_end(z.lower());
  const Interval above = of_end(z.upper());
  return {std::max(below.lower(), Integer(0)), std::min(above.upper(), Interval(1).upper())};
}

Interval student_t_distribution(const Interval& z, double degrees_of_freedom) {
  const boost::math::students_t_distribution<double> t(degrees_of_freedom);
  const auto at = [&](const Integer& end) {
    return boost::math::cdf(t, (end / power_of_ten(places - 25)).convert_to<double>() * 1e-25);
  };
  const Interval slack = Interval::of(1e-12);
  const Interval low = Interval::of(at(z.lower())) - slack, high = Interval::of(at(z.upper())) + slack;
  return {larger(low, 0).lower(), smaller(high, 1).upper()};
}

Interval coverage_factor(double degrees_of_freedom) {
  constexpr double beyond_two = 0.02275013194817921;  // probability of a standard normal value above 2
  const boost::math::students_t_distribution<double> t(degrees_of_freedom);
  return Interval::of(boost::math::quantile(boost::math::complement(t, beyond_two)));
}

}  // namespace axiometry::verification
