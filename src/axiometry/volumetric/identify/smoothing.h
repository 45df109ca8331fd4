// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/volumetric/identify/curvature_penalty.h"
#include "axiometry/volumetric/identify/equations/least_squares.h"
#include "axiometry/volumetric/identify/identification.h"

/// Smooth curves: how smooth, and what that does. Internal to identify().
namespace axiometry::volumetric::detail {

/// Fails on polynomials, and on what was stated and lies outside of these bounds.
Result<void> check_smoothness(const IdentifyOptions& options);

/// τ by restricted maximum likelihood, of displacements and of rotations, from a fit without penalty. With N the normal
/// equations, ĉ what N + S leaves of the fit's coefficients and V = (N + S)⁻¹, at the maximum
///   τ² = Σ D̂² / (number of D − tr V S),
/// which is repeated until it stands (the update of Fellner and Schall: Wood and Fasiolo 2017, eq. 6). Each is at least
/// Smoothness::least.
struct LikeliestBends {
  Bends bends{};
  bool settled = false;  ///< whether it settled before the rounds were used up
};
LikeliestBends likeliest_bends(const Problem& problem, const Fit& plain, CurvaturePenalty penalty);

/// What τ that were found are known by adds to the covariance of raw coefficients: with v = V S_g ĉ = ∂ĉ/∂ln τ_g²,
///   Σ_g v vᵀ · 2/Σ tr F²
/// over displacements and rotations, 2/Σ tr F² the variance of ln τ² by the information of the restricted likelihood
/// (Wood, Pya and Säfken 2016). `covariance` is that before φ, of which F is made; it returns `scaled` with this added.
std::vector<double> with_bend_uncertainty(const CurvaturePenalty& penalty, const Coefficients& coefficients,
                                          const Fit& fit, const std::vector<double>& covariance,
                                          std::vector<double> scaled);

/// Mean over 21 places of the variance of each curve; of the covariance of raw coefficients.
PerCurve mean_variances(const Coefficients& coefficients, const std::vector<double>& covariance);

/// What is told of it: from the fit with the penalty and its covariance before φ; without u_ratio, which identify()
/// sets.
SmoothedCurves smoothed_curves(const CurvaturePenalty& penalty, const Coefficients& coefficients, const Fit& fit,
                               const std::vector<double>& covariance);

}  // namespace axiometry::volumetric::detail
