// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/polar/polar_reduction.h"

#include <algorithm>

#include "axiometry/numeric/dense/dense.h"

namespace axiometry::tracking::detail {
namespace {

constexpr std::size_t untouched = static_cast<std::size_t>(-1);

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// Columns of the stations' unknowns that a row has, with their derivatives.
struct RowColumns {
  std::array<std::size_t, 7> column;
  std::array<double, 7> value;
  std::size_t count = 0;
};

RowColumns columns_of(const PolarLayout& layout, const PolarReading& reading, const PolarRow& row) {
  RowColumns columns;
  const std::size_t begin = layout.column[reading.station];
  const std::size_t pose = layout.has_angles[reading.station] ? 6 : 3;
  for (std::size_t k = 0; k < pose; ++k) {
    columns.column[k] = begin + k;
    columns.value[k] = row.pose[static_cast<Eigen::Index>(k)];
  }
  columns.count = pose;
  if (!layout.has_angles[reading.station]) {
    columns.column[pose] = begin + 3 + reading.segment;
    columns.value[pose] = row.dead;
    ++columns.count;
  }
  return columns;
}

/// Adds the readings of one point to the system and takes the point out of it.
class PointElimination {
 public:
  PointElimination(const PolarLayout& layout, PolarSystem& system)
      : layout_(layout), system_(system), local_(layout.columns, untouched) {}

  void add(const PolarReading& reading, const PolarRow& row) {
    system_.chi_squared += row.residual * row.residual;
    v_ += row.point * row.point.transpose();
    g_ += row.residual * row.point;
    const RowColumns columns = columns_of(layout_, reading, row);
    for (std::size_t a = 0; a < columns.count; ++a) {
      const auto i = static_cast<Eigen::Index>(columns.column[a]);
      for (std::size_t b = 0; b < columns.count; ++b)
        system_.reduced(i, static_cast<Eigen::Index>(columns.column[b])) += columns.value[a] * columns.value[b];
      system_.gradient[i] += row.residual * columns.value[a];
      system_.diagonal[i] += columns.value[a] * columns.value[a];
      if (local_[columns.column[a]] == untouched) {
        local_[columns.column[a]] = touched_.size();
        touched_.push_back(columns.column[a]);
        w_.emplace_back(Eigen::Vector3d::Zero());
      }
      w_[local_[columns.column[a]]] += columns.value[a] * row.point;
    }
  }

  PolarBlock take() {
    PolarBlock block;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(v_, Eigen::EigenvaluesOnly);
    block.narrowest = spread.eigenvalues()[0] / spread.eigenvalues()[2];
    block.covariance = v_.inverse();
    Eigen::MatrixXd w(3, static_cast<Eigen::Index>(touched_.size()));
    for (std::size_t k = 0; k < touched_.size(); ++k) w.col(static_cast<Eigen::Index>(k)) = w_[k];
    block.shares = block.covariance * w;
    block.step = block.covariance * g_;
    const Eigen::MatrixXd part = w.transpose() * block.shares;
    const Eigen::VectorXd gradient = w.transpose() * block.step;
    for (std::size_t a = 0; a < touched_.size(); ++a) {
      const auto i = static_cast<Eigen::Index>(touched_[a]);
      system_.gradient[i] -= gradient[static_cast<Eigen::Index>(a)];
      for (std::size_t b = 0; b < touched_.size(); ++b)
        system_.reduced(i, static_cast<Eigen::Index>(touched_[b])) -=
            part(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
      local_[touched_[a]] = untouched;
    }
    block.columns = std::move(touched_);
    touched_.clear();
    w_.clear();
    v_.setZero();
    g_.setZero();
    return block;
  }

 private:
  const PolarLayout& layout_;
  PolarSystem& system_;
  std::vector<std::size_t> local_, touched_;
  std::vector<Eigen::Vector3d> w_;
  Eigen::Matrix3d v_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g_ = Eigen::Vector3d::Zero();
};

Matrix3 matrix(const Eigen::Matrix3d& m) {
  Matrix3 out{};
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      out[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = 0.5 * (m(i, k) + m(k, i));
  return out;
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// BᵀC and BᵀCB. Of a point BᵀC is −(BᵀC of the stations) Yᵀ, and with B of all points GᵀV⁻¹ more.
struct DatumPart {
  Eigen::MatrixXd with_stations;  ///< 6 × columns
  bool own = false;               ///< whether B is of all points
  Matrix6 inside = Matrix6::Zero();
  Matrix6 inverse = Matrix6::Zero();  ///< (BᵀG)⁻¹
};

DatumPart datum_of_station(const PolarLayout& layout, const Eigen::MatrixXd& c, const Eigen::MatrixXd& gauge,
                           std::size_t station) {
  DatumPart part;
  const auto at = static_cast<Eigen::Index>(layout.column[station]);
  part.with_stations = c.middleRows(at, 6);
  part.inside = c.block(at, at, 6, 6);
  part.inverse = Matrix6(gauge.middleRows(at, 6)).inverse();
  return part;
}

DatumPart datum_of_points(const PolarState& state, const PolarSystem& system, const Eigen::MatrixXd& c,
                          const Eigen::Vector3d& about) {
  DatumPart part;
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(6, c.cols());
  Matrix6 squares = Matrix6::Zero();
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    const auto g = place_gauge(about, state.points[i]);
    const PolarBlock& block = system.blocks[i];
    squares += g.transpose() * g;
    part.inside += g.transpose() * block.covariance * g;
    const Eigen::MatrixXd local = g.transpose() * block.shares;
    for (std::size_t k = 0; k < block.columns.size(); ++k)
      h.col(static_cast<Eigen::Index>(block.columns[k])) += local.col(static_cast<Eigen::Index>(k));
  }
  part.own = true;
  part.with_stations = -h * c;
  part.inside += h * c * h.transpose();
  part.inverse = squares.inverse();
  return part;
}

}  // namespace

PolarSystem reduce_polar(const PolarLayout& layout, std::span<const PolarReading> readings, const PolarState& state) {
  const auto q = static_cast<Eigen::Index>(layout.columns);
  PolarSystem system{Eigen::MatrixXd::Zero(q, q), Eigen::VectorXd::Zero(q), Eigen::VectorXd::Zero(q), 0.0, {}};
  system.blocks.reserve(state.points.size());
  PointElimination elimination(layout, system);
  std::array<PolarRow, 3> rows;
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    for (std::size_t t = layout.first[i]; t < layout.first[i + 1]; ++t) {
      const PolarReading& reading = readings[layout.reading[t]];
      const std::size_t count = polar_rows(reading, state, layout.has_angles[reading.station], rows);
      for (std::size_t k = 0; k < count; ++k) elimination.add(reading, rows[k]);
    }
    system.blocks.push_back(elimination.take());
  }
  return system;
}

double polar_chi_squared(const PolarLayout& layout, std::span<const PolarReading> readings, const PolarState& state) {
  double sum = 0.0;
  std::array<PolarRow, 3> rows;
  for (const PolarReading& reading : readings) {
    const std::size_t count = polar_rows(reading, state, layout.has_angles[reading.station], rows);
    for (std::size_t k = 0; k < count; ++k) sum += rows[k].residual * rows[k].residual;
  }
  return sum;
}

Eigen::Matrix<double, 3, 6> place_gauge(const Eigen::Vector3d& about, const Eigen::Vector3d& at) {
  Eigen::Matrix<double, 3, 6> g;
  g << Eigen::Matrix3d::Identity(), -cross_matrix(at - about);  // ω × (at − about)
  return g;
}

Eigen::MatrixXd station_gauge(const PolarLayout& layout, const PolarState& state, const Eigen::Vector3d& about) {
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(layout.columns), 6);
  for (std::size_t j = 0; j < layout.column.size(); ++j) {
    const auto at = static_cast<Eigen::Index>(layout.column[j]);
    g.middleRows(at, 3) = place_gauge(about, state.poses[j].at);
    if (layout.has_angles[j]) g.block(at + 3, 3, 3, 3) = Eigen::Matrix3d::Identity();
  }
  return g;
}

PolarInverse invert_polar(const PolarSystem& system, const Eigen::MatrixXd& gauge) {
  const Eigen::VectorXd scale = system.diagonal.cwiseSqrt();
  const Eigen::MatrixXd stretched = scale.asDiagonal() * gauge;
  const Eigen::MatrixXd n = numeric::orthonormal_basis(stretched);
  const Eigen::VectorXd inverse = scale.cwiseInverse();
  Eigen::MatrixXd a = inverse.asDiagonal() * system.reduced * inverse.asDiagonal();
  a = 0.5 * (a + a.transpose().eval());
  a += n * n.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(a);
  PolarInverse result;
  Eigen::VectorXd gains = solver.eigenvalues();
  for (Eigen::Index k = 0; k < gains.size(); ++k) {
    if (gains[k] < 1e-12) ++result.null_directions;
    gains[k] = gains[k] < 1e-12 ? 0.0 : 1.0 / gains[k];
  }
  result.covariance =
      solver.eigenvectors() * gains.asDiagonal() * solver.eigenvectors().transpose() - n * n.transpose();
  result.covariance = inverse.asDiagonal() * result.covariance * inverse.asDiagonal();
  return result;
}

PolarCovariances polar_covariances(const PolarLayout& layout, const PolarState& state, const PolarSystem& system,
                                   const Eigen::MatrixXd& c, std::optional<std::size_t> station) {
  Eigen::Vector3d about = Eigen::Vector3d::Zero();
  for (const auto& p : state.points) about += p / static_cast<double>(state.points.size());
  const Eigen::MatrixXd gauge = station_gauge(layout, state, about);
  const DatumPart datum =
      station ? datum_of_station(layout, c, gauge, *station) : datum_of_points(state, system, c, about);
  const Matrix6 inside = datum.inverse * datum.inside * datum.inverse.transpose();
  const auto brought = [&](const Eigen::Matrix3d& own, const Eigen::Matrix<double, 3, 6>& g,
                           const Eigen::Matrix<double, 6, 3>& with) {
    const Eigen::Matrix3d crossed = g * datum.inverse * with;
    return matrix(own - crossed - crossed.transpose() + g * inside * g.transpose());
  };
  PolarCovariances result;
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    const PolarBlock& block = system.blocks[i];
    const auto touched = static_cast<Eigen::Index>(block.columns.size());
    Eigen::MatrixXd part(touched, touched), with(6, touched);
    for (Eigen::Index a = 0; a < touched; ++a) {
      const auto column = static_cast<Eigen::Index>(block.columns[static_cast<std::size_t>(a)]);
      with.col(a) = datum.with_stations.col(column);
      for (Eigen::Index b = 0; b < touched; ++b)
        part(a, b) = c(column, static_cast<Eigen::Index>(block.columns[static_cast<std::size_t>(b)]));
    }
    const auto g = place_gauge(about, state.points[i]);
    Eigen::Matrix<double, 6, 3> with_point = -with * block.shares.transpose();
    if (datum.own) with_point += g.transpose() * block.covariance;
    result.points.push_back(brought(block.covariance + block.shares * part * block.shares.transpose(), g, with_point));
  }
  for (std::size_t j = 0; j < state.poses.size(); ++j) {
    const auto at = static_cast<Eigen::Index>(layout.column[j]);
    result.stations.push_back(
        brought(c.block(at, at, 3, 3), place_gauge(about, state.poses[j].at), datum.with_stations.middleCols(at, 3)));
  }
  return result;
}

}  // namespace axiometry::tracking::detail
