// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "axiometry/tracking/polar/polar_equations.h"

/// Equations without the points, and what comes back to these. Internal to adjust_polar().
///
/// All by orthogonal transformations: an angle of 60″ beside a length of 0.3 µm leaves the normal equations of the
/// stations fewer digits than a double has, and their rows half of them.
namespace axiometry::tracking::detail {

/// What the readings of one point leave of it: δp = −(v + Y δy) for the columns y that they touch.
struct PolarBlock {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< V⁻¹
  Eigen::MatrixXd shares;                                ///< Y = V⁻¹W, 3 × touched
  Eigen::Vector3d step = Eigen::Vector3d::Zero();        ///< v = V⁻¹g
  std::vector<std::size_t> columns;
  double narrowest = 0.0;  ///< smallest over largest singular value of its rows; 0: the rest is 0
};

struct PolarSystem {
  Eigen::MatrixXd triangle;  ///< K, upper triangular, of the least squares |K δy + b|² that the points leave: KᵀK = S
  Eigen::VectorXd right;     ///< b
  Eigen::VectorXd size;      ///< length of each column before the points were taken out; 1 of one without readings
  double chi_squared = 0.0;
  double gain = 0.0;               ///< by how much χ² falls, in first order, by the steps v of all points
  std::vector<PolarBlock> blocks;  ///< block per point
};
/// Damped, each unknown, of points as of stations, has an equation more: that it stays, √damping as long as its column.
/// With `residuals`, one for each row in the order of polar_residuals(), these take the place of the state's own.
PolarSystem reduce_polar(const PolarLayout& layout, std::span<const PolarReading> readings, const PolarState& state,
                         double damping = 0.0, std::span<const double> residuals = {});

/// Reading by reading, point by point.
std::vector<double> polar_residuals(const PolarLayout& layout, std::span<const PolarReading> readings,
                                    const PolarState& state);

double polar_chi_squared(const PolarLayout& layout, std::span<const PolarReading> readings, const PolarState& state);

/// The six directions that no reading sees: of the stations' unknowns (columns × 6) and of a place (3 × 6).
Eigen::Matrix<double, 3, 6> place_gauge(const Eigen::Vector3d& about, const Eigen::Vector3d& at);
Eigen::MatrixXd station_gauge(const PolarLayout& layout, const PolarState& state, const Eigen::Vector3d& about);

/// The stations' equations within their gauge.
struct PolarInverse {
  Eigen::MatrixXd factor;           ///< F, columns × (columns − 6): F Fᵀ is a symmetric generalised inverse of S
  Eigen::VectorXd step;             ///< δy
  double gain = 0.0;                ///< by how much χ² falls, in first order, by that step
  std::size_t null_directions = 0;  ///< beyond the gauge: then the rest is not computed
};
PolarInverse invert_polar(const PolarSystem& system, const Eigen::MatrixXd& gauge);

/// Brings covariances to a datum (S-transformation): C' = T C Tᵀ, T = I − G (BᵀG)⁻¹ Bᵀ, B the unknowns that the datum
/// holds still: those of one station, or by inner constraints all points.
struct PolarCovariances {
  std::vector<Matrix3> points;
  std::vector<Matrix3> stations;
};
PolarCovariances polar_covariances(const PolarLayout& layout, const PolarState& state, const PolarSystem& system,
                                   const Eigen::MatrixXd& factor, std::optional<std::size_t> station);

}  // namespace axiometry::tracking::detail
