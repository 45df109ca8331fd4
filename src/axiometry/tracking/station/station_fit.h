// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/tracking/station/station.h"

/// The two estimators of station.h, each for itself.
namespace axiometry::tracking {

/// Below this share of the largest a singular value is nothing but rounding.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Eq. 14 solved. Of four points it has no solution, but the two candidates that fit them.
struct LinearEstimate {
  LinearFit fit;  ///< station, L0 and what follows from them where numerical_rank is 5; rank is left to judge_rank()
  std::size_t count = 0;  ///< number of points
  double scale_mm = 0.0;  ///< rms radius of the points
  /// Right singular vectors (a, b, c) of the scaled matrix, by falling singular value: the last is the relation
  /// a·p + bΔL + c = 0 that the points fulfil best.
  std::array<std::array<double, 5>, 5> directions{};
  /// Stations for which ψ = |s|² − L0² holds along the last direction: at most two, one of them near the truth also
  /// where eq. 14 is critical.
  std::vector<Vector3> candidates;
  std::vector<Vector3> gain;            ///< change of the station per change of ΔL_i
  std::vector<double> misclosure_gain;  ///< change of the misclosure per change of ΔL_i, mm
};
LinearEstimate solve_linear(std::span<const LocationPoint> points);

/// Standard uncertainties of what stands in the matrix of eq. 14.
struct MatrixNoise {
  double length_mm = 0.0;
  double point_mm = 0.0;  ///< standard uncertainty of a point, per axis
};
/// Sets rank and rank_tolerance: the singular value σ_k with the direction (a, b, c) counts when it is above
/// 3 √n (2/r) √(|a|² u_p² + b² u_L²) + n ε σ_1, three times what the noise alone makes of it.
void judge_rank(LinearEstimate& solution, const MatrixNoise& noise);

/// σ_i of a length, at the distance, with the machine's share along the beam.
double length_sigma_mm(const StationOptions& options, double distance_mm);

/// A minimum of the refined problem.
struct Minimum {
  Vector3 station_mm;
  double L0_mm = 0.0;
  double step_mm = 0.0;  ///< the coefficient of `shape`
  double chi_squared = 0.0;
  std::size_t iterations = 0;
  bool converged = false;
};

/// From one start. With a `shape` (as many as points; empty: none) the lengths may be wrong by step · shape_i, step
/// being found along.
Minimum refine(std::span<const LocationPoint> points, const StationOptions& options, Vector3 start_mm,
               std::span<const double> shape = {});

/// Starts all around the points, the given ones first.
std::vector<Vector3> starts_around(std::span<const LocationPoint> points, std::span<const Vector3> first);

/// The different minima, the smallest χ² first. Of more than 400 points 200 show where these are; what they find is
/// refined with all, so that the time grows as the points do. With a limit none where these 200 leave more than
/// `chi_squared_most`, since all points cannot leave less, or end at no minimum.
std::vector<Minimum> refine_from_all(std::span<const LocationPoint> points, const StationOptions& options,
                                     std::span<const Vector3> starts, std::span<const double> shape = {},
                                     double chi_squared_most = std::numeric_limits<double>::infinity());

/// Residuals, covariance and condition at a minimum; and what a change of ΔL_i changes there.
struct RefinedSolution {
  RefinedFit fit;
  std::vector<Vector3> gain;
  Vector3 weakest;            ///< direction in which the station is known least, of length 1
  double weakest_u_mm = 0.0;  ///< its standard uncertainty, from the σ stated
  std::vector<double> distances_mm;
};
RefinedSolution describe(std::span<const LocationPoint> points, const StationOptions& options, const Minimum& minimum);

}  // namespace axiometry::tracking
