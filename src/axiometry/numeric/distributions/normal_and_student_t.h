// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Distribution functions of the normal and of Student's t distribution, and their inverses.
///
/// Φ comes from the complementary error function. Φ_ν comes from the regularised incomplete beta function
/// I_x(ν/2, 1/2), x = ν/(ν + t²), by its continued fraction (NIST DLMF 8.17.22, modified Lentz method); both
/// inverses are Newton steps on the logarithm of the smaller tail. The smaller tail is exact to a relative 1e-12
/// for |z| < 37, and for ν from 0.1 to 1e4 and tails above 1e-250; beyond ν = 1e4 digits are lost with ν (1e-16·ν, as
/// x nears 1), until the normal distribution stands in above 1e8 (relative difference below t⁴/(4ν)).
/// normal_and_student_t_test.cpp holds figures computed with sixty digits.
namespace axiometry::numeric {

/// The continued fraction of I_x(a, b) without its factor x^a (1 − x)^b / (a B(a, b)); converges fast for
/// x < (a + 1)/(a + b + 2).
double beta_fraction(double a, double b, double x);

double normal_probability(double z);  ///< Φ(z)
double normal_quantile(double p);     ///< Φ⁻¹(p); contract: 0 < p < 1

double student_t_probability(double t, double degrees_of_freedom);  ///< Φ_ν(t); contract: ν > 0, may be infinite
double student_t_quantile(double p, double degrees_of_freedom);     ///< Φ_ν⁻¹(p); contract: ν > 0, 0 < p < 1

}  // namespace axiometry::numeric
