// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Polynomials of the Box–Muller transformation, lowest power first. Made by tools/make_normal_polynomials.py with
/// 60 digits; the errors are those of the rounded coefficients over the whole range, without the rounding of their
/// evaluation.
namespace axiometry::numeric {

template <typename Number>
struct NormalPolynomials;

template <>
struct NormalPolynomials<double> {
  /// −2 ln m = s·p(s²), s = (m − 1)/(m + 1), √½ ≤ m ≤ √2; within 4.6e-18 of the value.
  static constexpr double logarithm[] = {-0x1p+2,
                                         -0x1.5555555555558p+0,
                                         -0x1.99999999952e2p-1,
                                         -0x1.2492492df148dp-1,
                                         -0x1.c71c62e5800a1p-2,
                                         -0x1.7462b4ab2ef6bp-2,
                                         -0x1.39fe606542ddep-2,
                                         -0x1.2b584aae78a57p-2};
  /// sin(π/2·w) = w·p(w²), |w| ≤ ½; within 5.6e-17 of the value.
  static constexpr double sine[] = {0x1.921fb54442d18p+0,  -0x1.4abbce625be52p-1, 0x1.466bc6775a476p-4,
                                    -0x1.32d2cce500387p-8, 0x1.50783208843ebp-13, -0x1.e3027dea82bd7p-19,
                                    0x1.e4a9d9166f052p-25};
  /// cos(π/2·w) = p(w²), |w| ≤ ½; within 2.6e-17 of the value.
  static constexpr double cosine[] = {0x1p+0,
                                      -0x1.3bd3cc9be45dep+0,
                                      0x1.03c1f081b5ac0p-2,
                                      -0x1.55d3c7e3cb241p-6,
                                      0x1.e1f5068688d5bp-11,
                                      -0x1.a6d1eef479be1p-16,
                                      0x1.f9ce245cada0bp-22,
                                      -0x1.b2f3eb054afcdp-28};
};

template <>
struct NormalPolynomials<float> {
  static constexpr float logarithm[] = {-0x1p+2f, -0x1.55555cp+0f, -0x1.997c3p-1f, -0x1.2ee61p-1f};  ///< within 2.5e-9
  static constexpr float sine[] = {0x1.921fb6p+0f, -0x1.4abbccp-1f, 0x1.4665e8p-4f, -0x1.2ee7bcp-8f};  ///< 3.9e-8
  static constexpr float cosine[] = {0x1p+0f, -0x1.3bd3ccp+0f, 0x1.03c1eap-2f, -0x1.55cb98p-6f,
                                     0x1.db6492p-11f};  ///< 1.3e-8
};

}  // namespace axiometry::numeric
