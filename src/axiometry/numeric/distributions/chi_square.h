// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The distribution of χ² with ν degrees of freedom, from the regularised incomplete gamma function P(ν/2, x/2): its
/// series below ν/2 + 1, its continued fraction above (NIST DLMF 8.11.4, 8.9.2). The smaller tail is exact to a
/// relative 1e-12 for ν up to 1e4.
namespace axiometry::numeric {

double chi_square_probability(double x, double degrees_of_freedom);  ///< P(χ² ≤ x); contract: ν > 0
double chi_square_quantile(double p, double degrees_of_freedom);     ///< contract: ν > 0, 0 < p < 1

}  // namespace axiometry::numeric
