// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// The arithmetic of the second opinion: closed intervals that are proven to hold the exact value. It shares nothing
/// with the arithmetic that it checks. Method and bounds: docs/theory/verification.md.
namespace axiometry::verification {

/// Whole numbers of up to 1024 bits; one that would not fit throws std::range_error or std::overflow_error, which
/// the entries to this folder catch.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    1024, 1024, boost::multiprecision::signed_magnitude, boost::multiprecision::checked, void>>;

/// The ends of an interval are whole multiples of 10⁻⁴⁰.
inline constexpr int places = 40;

const Integer& power_of_ten(int exponent);  ///< 0 ≤ exponent ≤ 120

/// A decimal as it is spelled: digits · 10^exponent.
struct Decimal {
  Integer digits = 0;
  int exponent = 0;
};

/// Of "−4.1", "0,25", "1e-09": point or comma, hyphen or true minus sign. Nothing when it is no number, or beyond 10³⁰.
std::optional<Decimal> decimal_of(std::string_view text);

/// [lower, upper], both in units of 10⁻⁴⁰. Every operation rounds outwards.
class Interval {
 public:
  Interval() = default;
  Interval(int whole);
  Interval(Integer lower, Integer upper);  ///< ends in units of 10⁻⁴⁰, lower ≤ upper

  static Interval of(const Decimal& decimal);
  /// The shortest decimal that reads back as this double: what a file has said. Throws std::range_error beyond 10³⁰.
  static Interval of(double x);
  static Interval ratio(const Integer& numerator, const Integer& denominator);
  /// The root of a ratio of whole numbers, not below 0, that counts squares of 10⁻⁴⁰.
  static Interval root_of_squares(const Integer& numerator, const Integer& denominator);

  const Integer& lower() const { return lower_; }
  const Integer& upper() const { return upper_; }

  friend Interval operator+(const Interval& a, const Interval& b);
  friend Interval operator-(const Interval& a, const Interval& b);
  friend Interval operator*(const Interval& a, const Interval& b);
  /// Throws std::domain_error where the divisor holds 0.
  friend Interval operator/(const Interval& a, const Interval& b);

 private:
  Integer lower_ = 0;
  Integer upper_ = 0;
};

Interval magnitude(const Interval& a);
Interval root(const Interval& a);  ///< what is below 0 counts as 0
Interval larger(const Interval& a, const Interval& b);
Interval smaller(const Interval& a, const Interval& b);

bool surely_at_most(const Interval& a, const Interval& b);                    ///< a ≤ b whatever the exact values are
bool possibly_at_most(const Interval& a, const Interval& b);                  ///< a ≤ b for some
bool within(const Interval& a, const Interval& b, const Interval& distance);  ///< |a − b| ≤ distance is possible

/// The middle with so many significant digits, for messages: "9.6437".
std::string shown(const Interval& a, int digits = 12);

/// P(Z ≤ z) of the standard normal distribution, to 10⁻¹⁹.
Interval normal_distribution(const Interval& z);

/// The same of Student's t with ν > 0 degrees of freedom, to 10⁻¹²; by Boost.Math.
Interval student_t_distribution(const Interval& z, double degrees_of_freedom);
/// What of Student's t has the probability that ± 2 has of the standard normal distribution, to ten digits.
Interval coverage_factor(double degrees_of_freedom);

}  // namespace axiometry::verification
