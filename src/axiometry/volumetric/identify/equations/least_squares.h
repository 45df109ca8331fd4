// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/equations/linear_solution.h"
#include "axiometry/volumetric/identify/equations/normal_equations.h"

/// The lengths fitted by the errors, stations and dead paths. Internal to identify().
namespace axiometry::volumetric::detail {

struct Fit {
  State state;
  std::vector<double> residuals_um;
  std::vector<Vector3> beams;  ///< unit vectors from the station, per reading
  LinearSolution solution;
  double chi_squared = 0.0;
  std::size_t iterations = 0;
};

/// Gauss–Newton with the matrix of the first step (errors are so small that a new one would change the next digit by
/// 1e-4 of the step), which is made anew when a station moved by more than 1 mm or steps shrink slowly. A step that
/// makes χ² larger is halved. Ends with a step that is below 1e-4 in standard uncertainties, √(gᵀN⁻¹g), and is taken
/// still: what it leaves is less by as much as steps shrink, 1e-8 where 1e-4 is usual. Residuals are those before it,
/// which are off by less than 1e-4 σ. Of curves that are to be smooth, what their penalty adds is part of what is made
/// least, and no part of χ². Fails when there is none in 60 steps.
Result<Fit> least_squares(const Problem& problem, State start);

/// Robust scale of normalised residuals v/σ: 1.4826 times the median of their sizes, at least 1.
double robust_scale(const Problem& problem, std::span<const double> residuals_um);

/// Weights of Huber's loss at 2 robust standard deviations, from the residuals of a fit; zero weights stay zero.
std::vector<double> huber_weights(const Problem& problem, std::span<const double> residuals_um);

}  // namespace axiometry::volumetric::detail
