// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::tracking {

/// The straight part of the deviations along a linear axis; nothing is removed.
struct SlopeFit {
  double slope_um_per_m = 0.0;
  double uncertainty_um_per_m = 0.0;  ///< standard; 0 where two targets without repetition tell nothing
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< that it is known with
};

/// Weighted least squares over the targets: of the mean bidirectional deviations x̄_i (3.14) where there are any, else
/// of the unidirectional ones; weights are the numbers of readings. The uncertainty is the larger of that from the
/// scatter of the means about the line (which holds the positioning error itself) and that from the scatter of the
/// readings (s_i/√n_i), with the degrees of freedom of that one: m − 2 of m means about the line, or after Welch and
/// Satterthwaite from the n_i − 1 of the readings. Needs two positions.
SlopeFit fit_slope(std::span<const iso230_2::PositionResult> positions);

}  // namespace axiometry::tracking
