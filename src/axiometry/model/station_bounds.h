// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

/// How wide the covariance of a located station must be for bounds. docs/theory/station.md.
namespace axiometry {

/// By which the stated covariance of a station has to be multiplied so that who takes it for that of a normal station
/// has bounds of Δ⊥² that hold 95 %, however much more than stated the readings scatter. Δ⊥² of two equal components
/// over χ²/ν has the 95 % quantile ν (20^(2/ν) − 1), that of F(2, ν) twice, in place of 2 ln 20; of unequal ones it
/// grows by less. At least 1: the statement counts where it is more. 1 for ν = 0.
inline double widening_for_bounds(double chi_squared, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0) return 1.0;
  const double log_20 = std::log(20.0);  // 1 in 20 is outside
  return std::max(1.0,
                  chi_squared * std::expm1(2.0 * log_20 / static_cast<double>(degrees_of_freedom)) / (2.0 * log_20));
}

/// By which the stated covariance of a station is multiplied where its residuals are larger than stated: χ²/ν where
/// that is above 1 and ν > 0, else 1.
inline double inflation_of(double chi_squared, std::size_t degrees_of_freedom) {
  return degrees_of_freedom == 0 ? 1.0 : std::max(1.0, chi_squared / static_cast<double>(degrees_of_freedom));
}

}  // namespace axiometry
