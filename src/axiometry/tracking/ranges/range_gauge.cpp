// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/range_gauge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/numeric/dense/dense.h"

namespace axiometry::tracking::detail {
namespace {

constexpr double null_limit = 1e-12;

/// S with a unit diagonal of U, and an orthonormal basis of its gauge.
struct Scaled {
  Eigen::VectorXd size;  // size of each unknown: 1/√U_kk
  Eigen::MatrixXd matrix;
  Eigen::MatrixXd gauge;
};

Scaled scaled(const ReducedSystem& system, const GaugeDirections& directions) {
  const auto n = static_cast<Eigen::Index>(system.size);
  const auto g = static_cast<Eigen::Index>(directions.size());
  Scaled result;
  const Eigen::Map<const Eigen::VectorXd> diagonal(system.diagonal.data(), n);
  result.size = (diagonal.array() > 0.0).select(diagonal.array().rsqrt(), 1.0);
  const Eigen::Map<const Eigen::MatrixXd> matrix(system.matrix.data(), n, n);
  result.matrix = result.size.asDiagonal() * matrix * result.size.asDiagonal();
  Eigen::MatrixXd columns(n, g);
  for (Eigen::Index k = 0; k < g; ++k)
    columns.col(k) = Eigen::Map<const Eigen::VectorXd>(directions[static_cast<std::size_t>(k)].data(), n)
                         .cwiseQuotient(result.size)
                         .normalized();
  result.gauge = numeric::pivoted_orthonormal_basis(columns);
  return result;
}

}  // namespace

GaugeDirections gauge_directions(const RangeLayout& layout, const RangeState& state, double scale_length_mm,
                                 bool with_size) {
  GaugeDirections directions(with_size ? 7 : 6, std::vector<double>(layout.columns(), 0.0));
  Vector3 mean{};
  for (const Vector3& s : state.stations) mean += 1.0 / static_cast<double>(layout.stations) * s;
  for (std::size_t j = 0; j < layout.stations; ++j) {
    const std::size_t at = layout.station_column(j);
    const Vector3 off = 1.0 / scale_length_mm * (state.stations[j] - mean);
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3 axis{};
      axis[k] = 1.0;
      const Vector3 turn = cross(axis, off);
      for (std::size_t c = 0; c < 3; ++c) {
        directions[k][at + c] = axis[c];
        directions[3 + k][at + c] = turn[c];
      }
      if (with_size) directions[6][at + k] = off[k];
    }
    if (with_size && layout.free_scales) directions[6][at + 3] = -state.scales[j];
  }
  return directions;
}

std::vector<double> reduced_step(const ReducedSystem& system, const GaugeDirections& gauge) {
  const auto n = static_cast<Eigen::Index>(system.size);
  Scaled s = scaled(system, gauge);
  s.matrix += s.gauge * s.gauge.transpose();
  Eigen::VectorXd right = -s.size.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(system.gradient.data(), n));
  right -= s.gauge * (s.gauge.transpose() * right);
  const Eigen::VectorXd step = s.size.cwiseProduct(s.matrix.ldlt().solve(right));
  return {step.begin(), step.end()};
}

std::vector<double> reduced_covariance(const ReducedSystem& system, const GaugeDirections& gauge) {
  const auto n = static_cast<Eigen::Index>(system.size);
  Scaled s = scaled(system, gauge);
  s.matrix += s.gauge * s.gauge.transpose();
  Eigen::MatrixXd inverse = s.matrix.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  inverse -= s.gauge * s.gauge.transpose();
  inverse = 0.5 * (inverse + inverse.transpose().eval());
  inverse = s.size.asDiagonal() * inverse * s.size.asDiagonal();
  return {inverse.data(), inverse.data() + n * n};
}

ReducedRank reduced_rank(const ReducedSystem& system, const GaugeDirections& gauge, const RangeLayout& layout) {
  Scaled s = scaled(system, gauge);
  const Eigen::MatrixXd projector =
      Eigen::MatrixXd::Identity(s.gauge.rows(), s.gauge.rows()) - s.gauge * s.gauge.transpose();
  const double above = 1.0 + static_cast<double>(system.size);  // no eigenvalue of S exceeds its trace
  const Eigen::MatrixXd within = projector * s.matrix * projector + above * s.gauge * s.gauge.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(within);
  const Eigen::VectorXd& values = solver.eigenvalues();  // ascending; those of the gauge come last
  ReducedRank rank;
  while (rank.null_directions < system.size && values[static_cast<Eigen::Index>(rank.null_directions)] < null_limit)
    ++rank.null_directions;
  const auto beyond = values.size() - s.gauge.cols() - 1;
  const double least = std::max(values[0], std::numeric_limits<double>::min());
  rank.condition = rank.null_directions > 0 ? std::numeric_limits<double>::infinity()
                                            : values[std::max<Eigen::Index>(beyond, 0)] / least;
  const Eigen::VectorXd weakest = s.size.cwiseProduct(solver.eigenvectors().col(0));
  for (std::size_t j = 0; j < layout.stations; ++j) {
    const auto at = static_cast<Eigen::Index>(layout.station_column(j));
    const double moved = weakest.segment(at, 3).norm() / std::sqrt(least);
    if (!(moved > rank.weakest_mm)) continue;
    rank.weakest_mm = moved;
    rank.weakest_station = j;
  }
  return rank;
}

}  // namespace axiometry::tracking::detail
