// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// The distribution of χ² with ν degrees of freedom, from the regularised incomplete gamma function P(ν/2, x/2): its
/// series below ν/2 + 1, its continued fraction above (NIST DLMF 8.11.4, 8.9.2). The smaller tail is exact to a
/// relative 1e-12 for ν up to 1e3, 1e-11 up to 1e4, where ln Γ has the rounding of a large sum. Of whole ν the upper
/// tail has finite sums.
namespace axiometry::numeric {

double chi_square_probability(double x, double degrees_of_freedom);  ///< P(χ² ≤ x); contract: ν > 0

/// P(χ² ≥ x) of whole ν, small ones too, where 1 − P(χ² ≤ x) has lost its digits: by finite sums (DLMF 8.4.8
/// and 8.8.2), each term of which is exact to 1e-10 of itself for ν up to 10⁵. 1 for ν = 0; x may be infinite.
double chi_square_tail(double x, std::size_t degrees_of_freedom);

double chi_square_quantile(double p, double degrees_of_freedom);  ///< contract: ν > 0, 0 < p < 1

}  // namespace axiometry::numeric
