// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/tracking/polar/polar_network.h"

/// Readings as rows of equations. Internal to adjust_polar().
namespace axiometry::tracking::detail {

/// Columns of the stations' unknowns: position 3, and turn 3 with angles or one dead path for each segment without.
struct PolarLayout {
  std::vector<bool> has_angles;     ///< whether a station has angles
  std::vector<std::size_t> column;  ///< the first of each station
  std::vector<std::size_t> segments;
  std::size_t columns = 0;
  std::vector<std::size_t> first;    ///< place in `reading` per point; one more at the end
  std::vector<std::size_t> reading;  ///< indices of the readings, point by point
  std::size_t equations = 0;
};

struct PolarPose {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< p = at + turn · (what the station shows)
  std::vector<double> dead;                            ///< dead path per segment, of lengths alone
};

struct PolarState {
  std::vector<Eigen::Vector3d> points;
  std::vector<PolarPose> poses;
};

/// One equation over its standard uncertainty: residual = what the state makes of the reading less the reading.
struct PolarRow {
  double residual = 0.0;
  double sigma = 1.0;  ///< σ of the residual before that, mm for lengths, rad across the beam
  Eigen::Vector3d point;
  Eigen::Matrix<double, 6, 1> pose;  ///< position, then turn; of lengths alone the second half is 0
  double dead = 0.0;                 ///< derivative by the dead path of the segment; 0 with angles
};

PolarLayout lay_out_polar(std::size_t points, std::size_t stations, std::span<const PolarReading> readings);

/// The rows of a reading: 1, or 3 in the order length, sideways, upwards.
std::size_t polar_rows(const PolarReading& reading, const PolarState& state, bool has_angles,
                       std::array<PolarRow, 3>& rows);

/// Poses and points that are near enough for least squares. Fails as adjust_polar() says.
Result<PolarState> start_polar(const PolarLayout& layout, std::span<const PolarReading> readings,
                               const PolarOptions& options, std::vector<Finding>& findings);

/// The turn R with the least Σ |to − (R from + t)|², both about their means. Needs two directions.
Eigen::Matrix3d best_turn(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to);

std::string polar_station_name(const PolarOptions& options, std::size_t j);
std::string polar_point_name(const PolarOptions& options, std::size_t i);

}  // namespace axiometry::tracking::detail
