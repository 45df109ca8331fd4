// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"
#include "axiometry/tracking/station/station.h"

/// Multilateration (Lee et al., eq. 2): points and stations from lengths alone,
///   l_ij + l_0jk + w_ij = κ_j |p_i − s_j|,
/// with several stations at once or one that is moved. Points are eliminated (Schur complement), so that the work grows
/// with their number and not with its cube. Derivation, gauge and counting: docs/theory/multilateration.md.
namespace axiometry::tracking {

enum class ScaleModel {
  fixed,   ///< κ = 1: one interferometer whose scale is known
  common,  ///< one unknown κ for all stations: changes the size and nothing of the shape
  free,    ///< a scale for each station
};

struct MultilaterationOptions {
  ScaleModel scale = ScaleModel::fixed;
  double scale_prior = 0.0;  ///< standard uncertainty of κ about 1 (common, free); 0: none, the size is that of nominal
  RangingUncertainty ranging = {};
  /// Of the machine between stations measured in sequence, standard uncertainty along the beam, combined with the
  /// above.
  double repeatability_sigma_mm = 0.0;
  std::size_t iterations_most = 50;
  bool point_covariances = true;                    ///< also residuals over their own standard uncertainty
  bool find_breaks = true;                          ///< look for breaks of the beam that the readings do not state
  std::size_t threads = 0;                          ///< 0: as many as there are cores. The result does not depend on it
  std::stop_token stop = {};                        ///< nobody waits for it any more: fails, as unavailable
  std::span<const std::string> station_names = {};  ///< names for messages; numbers from 1 when empty
  std::span<const std::string> point_names = {};
};

/// What was found about whether the problem can be solved at all.
struct MultilaterationRank {
  std::size_t unknowns = 0;         ///< less the gauge
  std::size_t equations = 0;        ///< readings, and priors of scales
  std::size_t gauge = 6;            ///< 7 with a scale that nothing is known about
  std::size_t null_directions = 0;  ///< directions beyond the gauge that nothing tells: 0 when it can be solved
  double condition = 0.0;        ///< largest over smallest eigenvalue of the reduced system, scaled, within the gauge
  double weakest_mm = 0.0;       ///< standard uncertainty of a station along the direction known worst
  std::size_t points_least = 0;  ///< fewest points for so many stations that all see them (true minimum, not eq. 3)
  bool stations_coplanar = false;
  double stations_off_plane_mm = 0.0;  ///< largest distance of a station from the plane fitted to all
};

/// A break of the beam that the readings did not state: from `reading` on the station has a dead path of its own.
struct RangeBreak {
  std::size_t station = 0;
  std::size_t reading = 0;  ///< index among the readings
  double jump_mm = 0.0;     ///< jump of the length shown
};

struct MultilaterationFit {
  std::vector<Vector3> points_mm;
  std::vector<Vector3> stations_mm;
  std::vector<std::vector<double>> dead_paths_mm;  ///< l_0, per station and segment, those of `breaks` behind them
  std::vector<std::vector<double>> dead_path_sigmas_mm;
  std::vector<double> scales;  ///< κ per station
  std::vector<double> scale_sigmas;
  std::vector<Matrix3> point_covariances_mm2;  ///< inner constraints: the smallest trace; empty when not asked for
  std::vector<Matrix3> station_covariances_mm2;
  std::vector<double> residuals_mm;          ///< w_ij per reading
  std::vector<double> normalised_residuals;  ///< residuals over their uncertainty; 0 where nothing checks one
  std::vector<std::size_t> segments;         ///< segment of each reading, as used: after `breaks`
  std::vector<RangeBreak> breaks;
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;
  std::size_t iterations = 0;
  bool converged = false;
  MultilaterationRank rank;
  std::vector<Finding> findings;

  /// By which the covariances were multiplied: χ²/ν where that is above 1.
  double variance_factor() const {
    const double ratio = degrees_of_freedom > 0 ? chi_squared / static_cast<double>(degrees_of_freedom) : 1.0;
    return ratio > 1.0 ? ratio : 1.0;
  }
};

/// The least number of points that m stations need when all see all: 10, 7, 6, 6, 6 for m = 4 to 8 with fixed or common
/// scale and 13, 9, 8, 7, 7 with free scales, from 4m + 3n − 6 ≤ mn and 5m + 3n − 7 ≤ mn (eq. 3 forgets the gauge);
/// nothing when no number is enough. Numerical rank confirms it (tests/multilateration_oracle.py).
std::optional<std::size_t> points_least(std::size_t stations, ScaleModel scale);

/// `nominal_mm` are the points as the machine was told: start values, and by inner constraints the gauge (the result is
/// moved and turned onto them, with unknown scale also sized, by least squares; mirrored where that fits better).
/// Stations need no start. Readings of one station are in the order of measurement.
///
/// Fails, with the numbers, on readings of points or stations that do not exist, lengths that are not finite or
/// contradict the triangle inequality, on points seen by fewer than three stations, when the problem has null
/// directions beyond the gauge (fewer points than needed, coplanar stations), and when it does not converge.
Result<MultilaterationFit> multilaterate(std::span<const Vector3> nominal_mm, std::size_t stations,
                                         std::span<const RangeReading> readings, const MultilaterationOptions& options);

}  // namespace axiometry::tracking
