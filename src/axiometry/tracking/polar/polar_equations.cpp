// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/polar/polar_equations.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/ranges/range_eigen.h"

namespace axiometry::tracking::detail {

PolarLayout lay_out_polar(std::size_t points, std::size_t stations, std::span<const PolarReading> readings) {
  PolarLayout layout;
  layout.has_angles.assign(stations, false);
  layout.segments.assign(stations, 1);
  layout.first.assign(points + 1, 0);
  for (const PolarReading& r : readings) {
    if (r.direction) layout.has_angles[r.station] = true;
    layout.segments[r.station] = std::max(layout.segments[r.station], r.segment + 1);
    ++layout.first[r.point + 1];
    layout.equations += r.direction ? 3 : 1;
  }
  for (std::size_t j = 0; j < stations; ++j) {
    layout.column.push_back(layout.columns);
    layout.columns += 3 + (layout.has_angles[j] ? 3 : layout.segments[j]);
  }
  for (std::size_t i = 0; i < points; ++i) layout.first[i + 1] += layout.first[i];
  layout.reading.resize(readings.size());
  std::vector<std::size_t> next(layout.first.begin(), layout.first.end() - 1);
  for (std::size_t k = 0; k < readings.size(); ++k) layout.reading[next[readings[k].point]++] = k;
  return layout;
}

std::size_t polar_rows(const PolarReading& reading, const PolarState& state, bool has_angles,
                       std::array<PolarRow, 3>& rows) {
  const PolarPose& pose = state.poses[reading.station];
  const Eigen::Vector3d way = state.points[reading.point] - pose.at;
  const double d = way.norm();
  const Eigen::Vector3d u = way / d;
  PolarRow& length = rows[0];
  length.sigma = reading.length_sigma_mm;
  length.residual = (d - reading.length_mm - (has_angles ? 0.0 : pose.dead[reading.segment])) / length.sigma;
  length.point = u / length.sigma;
  length.pose << -length.point, Eigen::Vector3d::Zero();
  length.dead = has_angles ? 0.0 : -1.0 / length.sigma;
  if (!reading.direction) return 1;
  // Across the beam as it was read: the part of the direction u along two unit vectors e. With the turn changed by φ it
  // changes by −φ·(u × e), with the place by (e − (e·u)u)/d.
  const PolarFrame frame = polar_frame(*reading.direction);
  const double sigmas[] = {reading.direction->sideways_sigma_rad, reading.direction->upwards_sigma_rad};
  const Vector3 across[] = {frame.sideways, frame.upwards};
  for (std::size_t k = 0; k < 2; ++k) {
    PolarRow& row = rows[1 + k];
    const Eigen::Vector3d e = pose.turn * eigen(across[k]);
    row.sigma = sigmas[k];
    row.residual = e.dot(u) / row.sigma;
    row.point = (e - e.dot(u) * u) / (d * row.sigma);
    row.pose << -row.point, -u.cross(e) / row.sigma;
    row.dead = 0.0;
  }
  return 3;
}

Eigen::Matrix3d best_turn(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to) {
  Eigen::Vector3d a = Eigen::Vector3d::Zero(), b = a;
  for (const auto& v : from) a += v / static_cast<double>(from.size());
  for (const auto& v : to) b += v / static_cast<double>(to.size());
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < from.size(); ++k) product += (to[k] - b) * (from[k] - a).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) u.col(2) = -u.col(2);
  return u * svd.matrixV().transpose();
}

std::string polar_station_name(const PolarOptions& options, std::size_t j) {
  return j < options.station_names.size() ? options.station_names[j] : fmt::format("{}", j + 1);
}

std::string polar_point_name(const PolarOptions& options, std::size_t i) {
  return i < options.point_names.size() ? options.point_names[i] : fmt::format("{}", i + 1);
}

}  // namespace axiometry::tracking::detail
