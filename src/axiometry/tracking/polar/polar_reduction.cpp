// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/polar/polar_reduction.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/dense/orthogonal.h"

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

/// Rows of equations folded into a triangle as they come, the right side as one column more.
class FoldedRows {
 public:
  explicit FoldedRows(Eigen::Index columns) : rows_(Eigen::MatrixXd::Zero(2 * columns + rows_at_once, columns)) {}

  template <typename Row>
  void add(const std::vector<std::size_t>& columns, const Row& row) {
    if (count_ == rows_.rows()) fold();
    rows_.row(count_).setZero();
    for (std::size_t k = 0; k < columns.size(); ++k)
      rows_(count_, static_cast<Eigen::Index>(columns[k])) = row[static_cast<Eigen::Index>(k)];
    rows_(count_, rows_.cols() - 1) = row[row.size() - 1];
    ++count_;
  }

  Eigen::MatrixXd take() {
    fold();
    return rows_.topRows(count_);
  }

 private:
  static constexpr Eigen::Index rows_at_once = 64;

  void fold() {
    const Eigen::MatrixXd triangle = numeric::triangle_of(rows_.topRows(std::max(count_, rows_.cols())));
    rows_.setZero();
    count_ = triangle.rows();
    rows_.topRows(count_) = triangle;
  }

  Eigen::MatrixXd rows_;
  Eigen::Index count_ = 0;
};

/// Takes the rows of one point, and the point out of them.
class PointElimination {
 public:
  explicit PointElimination(const PolarLayout& layout) : layout_(layout), local_(layout.columns, untouched) {}

  void add(const PolarReading& reading, const PolarRow& row) {
    const RowColumns columns = columns_of(layout_, reading, row);
    for (std::size_t a = 0; a < columns.count; ++a) {
      if (local_[columns.column[a]] != untouched) continue;
      local_[columns.column[a]] = touched_.size();
      touched_.push_back(columns.column[a]);
    }
    rows_.push_back({row.point, columns, row.residual});
  }

  PolarBlock take(FoldedRows& folded, double damping) {
    const auto touched = static_cast<Eigen::Index>(touched_.size());
    // Three rows more for the damping; without it they are 0, and so is of fewer than three rows what they leave open.
    const auto count = static_cast<Eigen::Index>(rows_.size()) + 3;
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(count, 3 + touched + 1);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      all.row(i).head(3) = rows_[k].point.transpose();
      for (std::size_t a = 0; a < rows_[k].columns.count; ++a)
        all(i, 3 + static_cast<Eigen::Index>(local_[rows_[k].columns.column[a]])) = rows_[k].columns.value[a];
      all(i, 3 + touched) = rows_[k].residual;
    }
    const Eigen::RowVector3d lengths = all.leftCols(3).colwise().norm();
    all.bottomLeftCorner(3, 3) = Eigen::Matrix3d((std::sqrt(damping) * lengths).asDiagonal());
    const Eigen::MatrixXd turned = numeric::first_columns_eliminated(all, 3);
    PolarBlock block;
    const Eigen::Matrix3d r = turned.topLeftCorner<3, 3>();
    const Eigen::JacobiSVD<Eigen::Matrix3d> spread(r);
    block.narrowest = spread.singularValues()[2] / spread.singularValues()[0];
    block.columns = touched_;
    block.shares = Eigen::MatrixXd::Zero(3, touched);
    if (block.narrowest > 0.0) {
      const Eigen::Matrix3d inverse = r.inverse();
      block.covariance = inverse * inverse.transpose();
      block.shares = inverse * turned.block(0, 3, 3, touched);
      block.step = inverse * turned.block(0, 3 + touched, 3, 1);
      for (Eigen::Index k = 3; k < count; ++k) folded.add(block.columns, turned.row(k).tail(touched + 1));
    }
    gain_ += turned.block(0, 3 + touched, 3, 1).squaredNorm();
    for (const std::size_t column : touched_) local_[column] = untouched;
    touched_.clear();
    rows_.clear();
    return block;
  }

  double gain() const { return gain_; }

 private:
  struct Row {
    Eigen::Vector3d point;
    RowColumns columns;
    double residual = 0.0;
  };
  const PolarLayout& layout_;
  std::vector<std::size_t> local_, touched_;
  std::vector<Row> rows_;
  double gain_ = 0.0;
};

Matrix3 matrix(const Eigen::Matrix3d& m) {
  Matrix3 out{};
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      out[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = 0.5 * (m(i, k) + m(k, i));
  return out;
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// BᵀF, and of what each point has for itself BᵀV⁻¹B.
struct DatumPart {
  Eigen::MatrixXd with_stations;      ///< 6 × columns of F
  Matrix6 own = Matrix6::Zero();      ///< 0 where B is of a station
  Matrix6 inverse = Matrix6::Zero();  ///< (BᵀG)⁻¹
};

DatumPart datum_of_station(const PolarLayout& layout, const Eigen::MatrixXd& factor, const Eigen::MatrixXd& gauge,
                           std::size_t station) {
  const auto at = static_cast<Eigen::Index>(layout.column[station]);
  DatumPart part;
  part.with_stations = factor.middleRows(at, 6);
  part.inverse = numeric::inverse(gauge.middleRows(at, 6));
  return part;
}

/// −Y F: how a point follows the stations.
Eigen::MatrixXd followed(const PolarBlock& block, const Eigen::MatrixXd& factor) {
  return -block.shares * factor(block.columns, Eigen::all);
}

DatumPart datum_of_points(const PolarState& state, const PolarSystem& system, const Eigen::MatrixXd& factor,
                          const Eigen::Vector3d& about) {
  DatumPart part;
  part.with_stations = Eigen::MatrixXd::Zero(6, factor.cols());
  Matrix6 squares = Matrix6::Zero();
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    const auto g = place_gauge(about, state.points[i]);
    squares += g.transpose() * g;
    part.own += g.transpose() * system.blocks[i].covariance * g;
    part.with_stations += g.transpose() * followed(system.blocks[i], factor);
  }
  part.inverse = numeric::inverse(squares);
  return part;
}

}  // namespace

PolarSystem reduce_polar(const PolarLayout& layout, std::span<const PolarReading> readings, const PolarState& state,
                         double damping, std::span<const double> residuals) {
  const auto q = static_cast<Eigen::Index>(layout.columns);
  PolarSystem system;
  system.blocks.reserve(state.points.size());
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(q);
  FoldedRows folded(q + 1);
  PointElimination elimination(layout);
  std::array<PolarRow, 3> rows;
  std::size_t next = 0;
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    for (std::size_t t = layout.first[i]; t < layout.first[i + 1]; ++t) {
      const PolarReading& reading = readings[layout.reading[t]];
      const std::size_t count = polar_rows(reading, state, layout.has_angles[reading.station], rows);
      for (std::size_t k = 0; k < count; ++k) {
        if (!residuals.empty()) rows[k].residual = residuals[next++];
        system.chi_squared += rows[k].residual * rows[k].residual;
        const RowColumns columns = columns_of(layout, reading, rows[k]);
        for (std::size_t a = 0; a < columns.count; ++a)
          squares[static_cast<Eigen::Index>(columns.column[a])] += columns.value[a] * columns.value[a];
        elimination.add(reading, rows[k]);
      }
    }
    system.blocks.push_back(elimination.take(folded, damping));
  }
  system.size = (squares.array() > 0.0).select(squares.array().sqrt(), 1.0);
  if (damping > 0.0)
    for (Eigen::Index k = 0; k < q; ++k)
      folded.add({static_cast<std::size_t>(k)}, Eigen::RowVector2d(std::sqrt(damping) * system.size[k], 0.0));
  const Eigen::MatrixXd triangle = folded.take();
  system.triangle = triangle.topLeftCorner(q, q);
  system.right = triangle.col(q).head(q);
  system.gain = elimination.gain();
  return system;
}

std::vector<double> polar_residuals(const PolarLayout& layout, std::span<const PolarReading> readings,
                                    const PolarState& state) {
  std::vector<double> residuals;
  std::array<PolarRow, 3> rows;
  for (const std::size_t at : layout.reading) {
    const PolarReading& reading = readings[at];
    const std::size_t count = polar_rows(reading, state, layout.has_angles[reading.station], rows);
    for (std::size_t k = 0; k < count; ++k) residuals.push_back(rows[k].residual);
  }
  return residuals;
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
  // Unknowns in units of their columns: what rounding makes of these is then below 1e-13 in every direction.
  constexpr double null_limit = 1e-12;
  const Eigen::Index q = system.size.size(), open = q - gauge.cols();
  const Eigen::VectorXd unit = system.size.cwiseInverse();
  const Eigen::MatrixXd basis = numeric::completed_orthonormal_basis(system.size.asDiagonal() * gauge).rightCols(open);
  PolarInverse result;
  result.factor = Eigen::MatrixXd::Zero(q, open);
  result.step = Eigen::VectorXd::Zero(q);
  if (open == 0) return result;
  const Eigen::MatrixXd within = system.triangle * unit.asDiagonal() * basis;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.compute(within);
  for (Eigen::Index k = 0; k < open; ++k)
    if (!(std::abs(qr.matrixR()(k, k)) > null_limit)) ++result.null_directions;
  if (result.null_directions > 0) return result;
  result.factor = unit.asDiagonal() * (basis * numeric::inverse_of_triangle(qr));
  const Eigen::VectorXd told = numeric::turned_right(qr, system.right);
  result.gain = told.head(open).squaredNorm();
  result.step = -result.factor * told.head(open);
  return result;
}

PolarCovariances polar_covariances(const PolarLayout& layout, const PolarState& state, const PolarSystem& system,
                                   const Eigen::MatrixXd& factor, std::optional<std::size_t> station) {
  Eigen::Vector3d about = Eigen::Vector3d::Zero();
  for (const auto& p : state.points) about += p / static_cast<double>(state.points.size());
  const Eigen::MatrixXd gauge = station_gauge(layout, state, about);
  const DatumPart datum =
      station ? datum_of_station(layout, factor, gauge, *station) : datum_of_points(state, system, factor, about);
  const Matrix6 own = datum.inverse * datum.own * datum.inverse.transpose();
  const auto brought = [&](const Eigen::MatrixXd& with, const Eigen::Matrix<double, 3, 6>& g) {
    const Eigen::MatrixXd moved = with - g * datum.inverse * datum.with_stations;
    return Eigen::Matrix3d(moved * moved.transpose() + g * own * g.transpose());
  };
  PolarCovariances result;
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    const PolarBlock& block = system.blocks[i];
    const auto g = place_gauge(about, state.points[i]);
    Eigen::Matrix3d covariance = brought(followed(block, factor), g) + block.covariance;
    if (!station) {
      const Eigen::Matrix3d crossed = g * datum.inverse * g.transpose() * block.covariance;
      covariance -= crossed + crossed.transpose();
    }
    result.points.push_back(matrix(covariance));
  }
  for (std::size_t j = 0; j < state.poses.size(); ++j) {
    const auto at = static_cast<Eigen::Index>(layout.column[j]);
    result.stations.push_back(matrix(brought(factor.middleRows(at, 3), place_gauge(about, state.poses[j].at))));
  }
  return result;
}

}  // namespace axiometry::tracking::detail
