// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"
#include "axiometry/tracking/station.h"

/// Multilateration (Lee et al., eq. 2): points and stations from lengths alone,
///   l_ij + l_0jk + w_ij = κ_j |p_i − s_j|,
/// with several stations at once or one that is moved. Points are eliminated (Schur complement), so that the work grows
/// with their number and not with its cube. Derivation, gauge and counting: docs/theory/multilateration.md.
namespace axiometry::tracking {

enum class ScaleModel {
  fixed,   ///< κ = 1: one interferometer whose scale is known
  common,  ///< one unknown κ for all stations, with a prior
  free,    ///< one per station: only the shape can be found, up to its size
};

struct MultilaterationOptions {
  ScaleModel scale = ScaleModel::fixed;
  double scale_prior = 0.0;  ///< standard uncertainty of κ about 1 (common); 0: none
  RangingUncertainty ranging = {};
  double repeatability_sigma_mm =
      0.0;  ///< of the machine between stations measured in sequence, combined with the above
  std::size_t iterations_most = 50;
  bool point_covariances = true;
};

/// What was found about whether the problem can be solved at all.
struct MultilaterationRank {
  std::size_t unknowns = 0;  ///< without gauge
  std::size_t equations = 0;
  std::size_t gauge = 6;            ///< 7 with free scales
  std::size_t null_directions = 0;  ///< beyond the gauge: 0 when it can
  double condition = 0.0;           ///< of the reduced system, scaled, within the gauge
  std::size_t points_least = 0;     ///< for so many stations, all seeing all points (spec: the true minimum, not eq. 3)
  bool stations_coplanar = false;
};

struct MultilaterationFit {
  std::vector<Vector3> points_mm;
  std::vector<Vector3> stations_mm;
  std::vector<std::vector<double>> dead_paths_mm;  ///< l_0, per station and segment
  std::vector<double> scales;                      ///< κ per station
  std::vector<Matrix3> point_covariances_mm2;      ///< inner constraints: the smallest trace; empty when not asked for
  std::vector<Matrix3> station_covariances_mm2;
  std::vector<double> residuals_mm;  ///< w_ij per reading
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;
  std::size_t iterations = 0;
  bool converged = false;
  MultilaterationRank rank;
  std::vector<Finding> findings;
};

/// The least number of points that m stations need when all see all: 10, 7, 6, 6, 6 for m = 4 to 8 with fixed scale and
/// 13, 9, 8, 7, 7 with free scales (5m + 3n − 7 ≤ mn and its like, which eq. 3 forgets to reduce by the gauge);
/// nothing when no number is enough.
std::optional<std::size_t> points_least(std::size_t stations, ScaleModel scale);

/// `nominal_mm` are the points as the machine was told: start values, and by inner constraints the gauge (the result is
/// moved and turned onto them, with free scales also sized, by least squares). Stations need no start.
///
/// Fails, with the numbers, on readings of points or stations that do not exist, lengths that are not finite or
/// contradict the triangle inequality, on points seen too rarely, when the problem has null directions beyond the gauge
/// (fewer points than needed, coplanar stations), and when it does not converge.
Result<MultilaterationFit> multilaterate(std::span<const Vector3> nominal_mm, std::size_t stations,
                                         std::span<const RangeReading> readings, const MultilaterationOptions& options);

}  // namespace axiometry::tracking
