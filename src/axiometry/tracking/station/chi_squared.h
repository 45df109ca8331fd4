// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace axiometry::tracking {

/// Probability that χ² of ν degrees of freedom is `x` or larger. By the finite sums for whole ν (DLMF 8.4.8 and 8.8.2);
/// each term is exact to 1e-13 of itself for ν up to 10⁵. 1 for ν = 0.
double chi_squared_tail(double x, std::size_t degrees_of_freedom);

}  // namespace axiometry::tracking
