// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "axiometry/tracking/polar/polar_equations.h"

/// Normal equations without the points, and what comes back to these. Internal to adjust_polar().
namespace axiometry::tracking::detail {

/// What the readings of one point leave of it: δp = −(v + Y δy) for the columns y that they touch.
struct PolarBlock {
  Eigen::Matrix3d covariance;  ///< V⁻¹
  Eigen::MatrixXd shares;      ///< Y = V⁻¹W, 3 × touched
  Eigen::Vector3d step;        ///< v = V⁻¹g
  std::vector<std::size_t> columns;
  double narrowest = 0.0;  ///< smallest over largest eigenvalue of V
};

struct PolarSystem {
  Eigen::MatrixXd reduced;   ///< S
  Eigen::VectorXd gradient;  ///< gradient in S δy = −gradient
  Eigen::VectorXd diagonal;  ///< diagonal of U, before the points were taken out of it
  double chi_squared = 0.0;
  std::vector<PolarBlock> blocks;  ///< block per point
};
PolarSystem reduce_polar(const PolarLayout& layout, std::span<const PolarReading> readings, const PolarState& state);

double polar_chi_squared(const PolarLayout& layout, std::span<const PolarReading> readings, const PolarState& state);

/// The six directions that no reading sees: of the stations' unknowns (columns × 6) and of a place (3 × 6).
Eigen::Matrix<double, 3, 6> place_gauge(const Eigen::Vector3d& about, const Eigen::Vector3d& at);
Eigen::MatrixXd station_gauge(const PolarLayout& layout, const PolarState& state, const Eigen::Vector3d& about);

/// S within its gauge.
struct PolarInverse {
  Eigen::MatrixXd covariance;       ///< a symmetric generalised inverse of S
  std::size_t null_directions = 0;  ///< directions beyond the gauge: eigenvalues of the scaled system below 1e-12
};
PolarInverse invert_polar(const PolarSystem& system, const Eigen::MatrixXd& gauge);

/// Brings covariances to a datum (S-transformation): C' = T C Tᵀ, T = I − G (BᵀG)⁻¹ Bᵀ, B the unknowns that the datum
/// holds still: those of one station, or by inner constraints all points.
struct PolarCovariances {
  std::vector<Matrix3> points;
  std::vector<Matrix3> stations;
};
PolarCovariances polar_covariances(const PolarLayout& layout, const PolarState& state, const PolarSystem& system,
                                   const Eigen::MatrixXd& stations_covariance, std::optional<std::size_t> station);

}  // namespace axiometry::tracking::detail
