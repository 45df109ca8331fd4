// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

/// Whether y ≤ T where both come from decimals. A binary double is not the decimal that a file states: 0.3 computed as
/// 0.1 + 0.2 is above 0.3. What follows keeps the decision that the decimals make.
/// Derivation and limits: docs/theory/verification.md.
namespace axiometry {

/// Unit roundoff of a double: one operation errs by at most u of its result.
inline constexpr double unit_roundoff = 0x1p-53;

/// The double nearest to the decimal that x stands for, when x is within `error` of it: the decimal with the fewest
/// places that is so near; x itself where there is none. Exact whenever the decimal's last place is more than eight
/// times the error: another decimal of as few places would be a last place away. `error` ≥ 0.
inline double nearest_decimal(double x, double error) {
  // Powers up to 10^22 and whole numbers up to 2^53 are exact, so that the quotient is the nearest double.
  constexpr double whole_limit = 0x1p53;
  constexpr int places_max = 22;
  double scale = 1.0;
  for (int places = 0; places <= places_max; ++places, scale *= 10.0) {
    if (error * scale > 0.125 || std::abs(x) * scale >= whole_limit) break;
    const double candidate = std::nearbyint(x * scale) / scale;
    if (std::abs(candidate - x) <= error) return candidate;
  }
  return x;
}

/// The arithmetic that stands between decimals and a parameter of clause 3.
struct DecimalReadings {
  std::size_t targets = 0;  ///< m
  std::size_t runs = 0;     ///< n, the largest number of readings of a target and direction
  double magnitude = 0.0;   ///< X, the largest |x_ij|
};

/// How far x̄_i, E, M, B or B̄ may be from its exact value. With u the unit roundoff, readings within 4uX of their
/// decimals (read, and converted by two operations), sums of n and m terms one after the other:
/// x̄_i: 4uX + nuX; B_i and ranges: twice that and 2uX; B̄: m·2uX more. Together less than (2n + 2m + 14) uX.
inline double rounding_of_means(const DecimalReadings& readings) {
  const double operations = 2.0 * static_cast<double>(readings.runs + readings.targets) + 14.0;
  return operations * unit_roundoff * readings.magnitude;
}

/// How far s_i and what is made of it (R_i, R↑, R↓, R, A, A↑, A↓) may be from its exact value. s is a norm of
/// differences over √(n − 1), so that errors e of the differences move it by at most √(n/(n−1)) e ≤ 1.5 e, with
/// e = (4 + 4 + n + 2) uX; two-pass squares, sum, quotient and root add (n + 4) uX. A has four of these and two means,
/// R four and two; with their own sums less than (12n + 2m + 112) uX.
inline double rounding_of_spreads(const DecimalReadings& readings) {
  const double operations =
      12.0 * static_cast<double>(readings.runs) + 2.0 * static_cast<double>(readings.targets) + 112.0;
  return operations * unit_roundoff * readings.magnitude;
}

/// The largest double that cannot be told apart from the limit T by the decimals that a value y comes from: y is within
/// `rounding` of its exact value, and T the nearest double of a decimal, or one converted by at most three operations.
inline double end_of_tie(double limit, double rounding) {
  return limit + (rounding + 4.0 * unit_roundoff * std::abs(limit));
}

/// Whether y ≤ T as the decimals say. What cannot be told apart from the limit keeps it.
inline bool at_most(double y, double limit, double rounding) { return y <= end_of_tie(limit, rounding); }

}  // namespace axiometry
