// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "axiometry/model/series.h"

namespace axiometry::tracking {

/// The straight part of the deviations along a linear axis; nothing is removed.
struct SlopeFit {
  double slope_um_per_m = 0.0;
  double uncertainty_um_per_m = 0.0;  ///< standard; 0 where two targets without repetition tell nothing
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< that it is known with
};

/// Weighted least squares over the targets: of the mean bidirectional deviations x̄_i (3.14) where there are any, else
/// of the unidirectional ones; weights are the numbers of readings. The uncertainty is the largest of three, with the
/// degrees of freedom of that one: from the scatter of the means about the line, which holds the positioning error
/// itself (m − 2 of m means); from the scatter of the readings, s_i/√n_i (after Welch and Satterthwaite from the n_i −
/// 1); and, where chance makes slopes of the runs that differ so much in one of five lines at most (tilt_study), from
/// these: their standard deviation divided by √n (n − 1 of n runs), since an axis whose temperature changes between the
/// runs has another scale in each. Needs two positions.
SlopeFit fit_slope(const Series& series);

}  // namespace axiometry::tracking
