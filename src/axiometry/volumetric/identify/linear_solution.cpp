// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/linear_solution.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace axiometry::volumetric::detail {
namespace {

/// Eigenvalues of the scaled matrix below this share of the largest are rounding. Rows carry 1e-16 of themselves, so
/// that a direction of which they say nothing is left with 1e-15; a tool 1 mm beside the spindle gives 1e-7.
constexpr double null_share = 1e-11;

}  // namespace

struct LinearSolution::Factors {
  explicit Factors(const Coefficients& c) : coefficients(c), kept(c.kept()) {}

  Coefficients coefficients;
  std::vector<std::size_t> kept;  ///< columns under the gauge
  std::size_t raw_columns = 0;
  Eigen::VectorXd scale;   ///< 1/√ of the diagonal
  Eigen::MatrixXd matrix;  ///< scaled
  Eigen::LLT<Eigen::MatrixXd> cholesky;
  bool has_cholesky = false;
  Eigen::MatrixXd vectors;   ///< of all eigenvalues, where a direction is not told
  Eigen::VectorXd inverses;  ///< 1/eigenvalue, 0 of those that are not told
  std::size_t nulls = 0;
  double condition = 0.0;  ///< where a direction is not told

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    if (has_cholesky) return cholesky.solve(right);
    return vectors * inverses.cwiseProduct(vectors.transpose() * right);
  }
  void factor_by_eigenvalues() {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    const Eigen::VectorXd& values = solver.eigenvalues();  // rising
    const double least = null_share * values[values.size() - 1];
    while (nulls < static_cast<std::size_t>(values.size()) && values[static_cast<Eigen::Index>(nulls)] < least) ++nulls;
    const auto first = std::min(static_cast<Eigen::Index>(nulls), values.size() - 1);
    condition = std::sqrt(values[values.size() - 1] / std::max(values[first], std::numeric_limits<double>::min()));
    vectors = solver.eigenvectors();
    inverses = values.cwiseInverse();
    inverses.head(static_cast<Eigen::Index>(nulls)).setZero();
    has_cholesky = false;
  }
  Eigen::VectorXd kept_part(std::vector<double> raw) const {
    coefficients.turn_vector(raw);
    Eigen::VectorXd part(static_cast<Eigen::Index>(kept.size()));
    for (std::size_t k = 0; k < kept.size(); ++k) part[static_cast<Eigen::Index>(k)] = raw[kept[k]];
    return part;
  }
  /// Free coefficients as raw ones, other columns as they are.
  std::vector<double> raw_of(const Eigen::VectorXd& part) const {
    const std::size_t free = coefficients.free();
    std::vector<double> raw = coefficients.raw_of({part.data(), free});
    raw.resize(raw_columns, 0.0);
    for (std::size_t k = free; k < kept.size(); ++k) raw[kept[k]] = part[static_cast<Eigen::Index>(k)];
    return raw;
  }
  /// Columns of the inverse of the scaled matrix.
  Eigen::MatrixXd inverse_columns(Eigen::Index first, Eigen::Index count) const {
    const auto n = matrix.rows();
    if (!has_cholesky) return vectors * inverses.asDiagonal() * vectors.middleRows(first, count).transpose();
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(n, count);
    columns.middleRows(first, count).setIdentity();
    cholesky.solveInPlace(columns);
    return columns;
  }
};

LinearSolution::LinearSolution(const Coefficients& coefficients, NormalEquations equations)
    : factors_(std::make_unique<Factors>(coefficients)) {
  Factors& f = *factors_;
  const std::size_t n = equations.columns;
  f.raw_columns = n;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < i; ++k) equations.matrix[i * n + k] = equations.matrix[k * n + i];
  coefficients.turn(equations.matrix, n);
  for (std::size_t k = coefficients.raw(); k < n; ++k) f.kept.push_back(k);
  const auto size = static_cast<Eigen::Index>(f.kept.size());
  f.scale.resize(size);
  f.matrix.resize(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const std::size_t row = f.kept[static_cast<std::size_t>(i)];
    const double diagonal = equations.matrix[row * n + row];
    f.scale[i] = diagonal > 0.0 ? 1.0 / std::sqrt(diagonal) : 1.0;
  }
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index k = 0; k < size; ++k)
      f.matrix(k, i) = f.scale[i] * f.scale[k] *
                       equations.matrix[f.kept[static_cast<std::size_t>(i)] * n + f.kept[static_cast<std::size_t>(k)]];
  f.cholesky.compute(f.matrix);
  f.has_cholesky = f.cholesky.info() == Eigen::Success;
  const double reciprocal = f.has_cholesky ? f.cholesky.rcond() : 0.0;
  // In the 1-norm the condition is larger than by eigenvalues, at most by the number of unknowns: nothing is missed.
  if (!(reciprocal > null_share)) f.factor_by_eigenvalues();
}

LinearSolution::~LinearSolution() = default;
LinearSolution::LinearSolution(LinearSolution&&) noexcept = default;
LinearSolution& LinearSolution::operator=(LinearSolution&&) noexcept = default;

std::size_t LinearSolution::unknowns() const { return factors_->kept.size(); }
std::size_t LinearSolution::null_directions() const { return factors_->nulls; }

double LinearSolution::condition() const {
  if (!factors_->has_cholesky) return factors_->condition;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(factors_->matrix, Eigen::EigenvaluesOnly);
  const Eigen::VectorXd& values = solver.eigenvalues();
  return std::sqrt(values[values.size() - 1] / values[0]);
}

std::vector<double> LinearSolution::step(std::vector<double> raw_gradient) const {
  const Factors& f = *factors_;
  const Eigen::VectorXd right = f.scale.cwiseProduct(f.kept_part(std::move(raw_gradient)));
  return f.raw_of(f.scale.cwiseProduct(f.solve(right)));
}

std::vector<double> LinearSolution::coefficient_covariance() const {
  const Factors& f = *factors_;
  const auto free = static_cast<Eigen::Index>(f.coefficients.free());
  const Eigen::MatrixXd columns = f.inverse_columns(0, free);
  std::vector<double> covariance(f.coefficients.free() * f.coefficients.free());
  for (Eigen::Index i = 0; i < free; ++i)
    for (Eigen::Index k = 0; k < free; ++k)
      covariance[static_cast<std::size_t>(i * free + k)] = f.scale[i] * f.scale[k] * columns(k, i);
  return f.coefficients.raw_covariance(covariance);
}

Matrix3 LinearSolution::block(std::size_t column) const {
  const Factors& f = *factors_;
  const auto first = static_cast<Eigen::Index>(std::ranges::lower_bound(f.kept, column) - f.kept.begin());
  const Eigen::MatrixXd columns = f.inverse_columns(first, 3);
  Matrix3 block;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      block[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
          f.scale[first + i] * f.scale[first + k] * columns(first + i, k);
  return block;
}

std::vector<std::vector<double>> LinearSolution::unseen() const {
  const Factors& f = *factors_;
  std::vector<std::vector<double>> directions;
  for (std::size_t k = 0; k < f.nulls; ++k) {
    const Eigen::VectorXd direction = f.scale.cwiseProduct(f.vectors.col(static_cast<Eigen::Index>(k)));
    std::vector<double> raw = f.raw_of(direction);
    raw.resize(f.coefficients.raw());
    double squares = 0.0;
    for (const double x : raw) squares += x * x;
    if (squares < 1e-20 * direction.squaredNorm()) continue;  // of stations alone
    for (double& x : raw) x /= std::sqrt(squares);
    directions.push_back(std::move(raw));
  }
  return directions;
}

double LinearSolution::variance(std::span<const BeamRow::Piece> row) const {
  const Factors& f = *factors_;
  std::vector<double> raw(f.raw_columns, 0.0);
  for (const BeamRow::Piece& piece : row)
    for (std::size_t k = 0; k < piece.count; ++k) raw[piece.first + k] += piece.values[k];
  const Eigen::VectorXd a = f.scale.cwiseProduct(f.kept_part(std::move(raw)));
  return std::max(0.0, a.dot(f.solve(a)));
}

}  // namespace axiometry::volumetric::detail
