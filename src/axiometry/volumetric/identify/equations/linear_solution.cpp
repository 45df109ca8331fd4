// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/equations/linear_solution.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "axiometry/volumetric/field/error_model.h"
#include "axiometry/volumetric/identify/curvature_penalty.h"

#include "axiometry/numeric/dense/dense.h"

namespace axiometry::volumetric::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double null_most = 1e-8;
/// What rounding makes of the eigenvalue 0 of a matrix with a unit diagonal and some hundred rows.
constexpr double rounded_zero = 1e-15;
/// A direction that would make the uncertainty of a number larger by less than 0.5 % (√(1 + 0.1²)) tells nothing
/// against the number, and leaving it out moves the number by a tenth of that uncertainty. Rounding stays far below: it
/// gives an eigenvector a share ε/λ of another one with the eigenvalue λ, ε being rounded_zero, which over √ε is √(ε/λ)
/// of the 1/√λ that the other is uncertain by, at most 3e-4 where λ is above null_most.
constexpr double harmless_share = 0.1;

/// Under the gauge, columns scaled to a unit diagonal. Coefficients last: then the inverse of their block of the factor
/// is all that their covariance needs.
struct Scaled {
  std::vector<std::size_t> kept;  ///< columns under the gauge
  VectorXd scale;                 ///< 1/√ of the diagonal
  MatrixXd matrix;
};

Scaled scaled(const Coefficients& coefficients, NormalEquations equations) {
  const std::size_t n = equations.columns;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < i; ++k) equations.matrix[i * n + k] = equations.matrix[k * n + i];
  coefficients.turn(equations.matrix, n);
  Scaled s;
  for (std::size_t k = coefficients.raw(); k < n; ++k) s.kept.push_back(k);
  s.kept.insert(s.kept.end(), coefficients.kept().begin(), coefficients.kept().end());
  const auto size = static_cast<Index>(s.kept.size());
  const auto place = [&](Index i) { return s.kept[static_cast<std::size_t>(i)]; };
  s.scale.resize(size);
  s.matrix.resize(size, size);
  for (Index i = 0; i < size; ++i) {
    const double diagonal = equations.matrix[place(i) * n + place(i)];
    s.scale[i] = diagonal > 0.0 ? 1.0 / std::sqrt(diagonal) : 1.0;
  }
  for (Index i = 0; i < size; ++i)
    for (Index k = 0; k < size; ++k)
      s.matrix(k, i) = s.scale[i] * s.scale[k] * equations.matrix[place(i) * n + place(k)];
  return s;
}

/// A lower triangle in place, by halves, of which what is 0 is left out.
void invert_lower(Eigen::Ref<MatrixXd> l) {
  constexpr Index small = 24;
  const Index n = l.rows(), half = n / 2, rest = n - half;
  if (n <= small) {
    const MatrixXd inverse = l.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(n, n));
    l = inverse;
    return;
  }
  auto below = l.bottomLeftCorner(rest, half);
  l.topLeftCorner(half, half).triangularView<Eigen::Lower>().solveInPlace<Eigen::OnTheRight>(below);
  l.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>().solveInPlace(below);
  below *= -1.0;
  invert_lower(l.topLeftCorner(half, half));
  invert_lower(l.bottomRightCorner(rest, rest));
}

/// Wᵀ W of a lower triangle.
MatrixXd square_of_lower(const MatrixXd& w) {
  constexpr Index rows = 32;
  const Index n = w.rows();
  MatrixXd square = MatrixXd::Zero(n, n);
  for (Index first = 0; first < n; first += rows) {
    const Index count = std::min(rows, n - first), columns = first + count;
    square.topLeftCorner(columns, columns)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(w.block(first, 0, count, columns).transpose());
  }
  square.triangularView<Eigen::StrictlyUpper>() = square.transpose();
  return square;
}

/// Of a symmetric matrix of n rows by which apply() multiplies, the eigenvalue that is largest, by Lanczos' method with
/// full orthogonalisation. The residual is below 1e-6 of it, so that its error is about the square of that.
template <typename Apply>
double largest_eigenvalue(Index n, const Apply& apply) {
  constexpr double residual_most = 1e-6;
  constexpr Index looks_every = 8;
  MatrixXd basis(n, n);
  VectorXd diagonal(n), beside(n), v(n);
  for (Index i = 0; i < n; ++i) v[i] = 1.0 + std::sin(1.0 + 2.0 * static_cast<double>(i));  // near no eigenvector
  v.normalize();
  for (Index k = 0;; ++k) {
    basis.col(k) = v;
    VectorXd next = apply(v);
    diagonal[k] = v.dot(next);
    const auto known = basis.leftCols(k + 1);
    for (int twice = 0; twice < 2; ++twice) next -= (known * (known.transpose() * next)).eval();
    beside[k] = next.norm();
    const bool is_last = k + 1 == n || !(beside[k] > 1e-14 * std::abs(diagonal[0]));
    if (is_last || (k + 1) % looks_every == 0) {
      Eigen::SelfAdjointEigenSolver<MatrixXd> small;
      small.computeFromTridiagonal(diagonal.head(k + 1), beside.head(k));
      const double largest = small.eigenvalues()[k];
      if (is_last || !(beside[k] * std::abs(small.eigenvectors()(k, k)) > residual_most * largest)) return largest;
    }
    v = next / beside[k];
  }
}

/// Of a direction as long as one standard deviation, whole curves, means and halves of reversal each, and squareness:
/// those of which it makes no number more uncertain than harmless_share says become 0.
void keep_what_takes_part(const Coefficients& coefficients, std::span<const double> covariance,
                          std::vector<double>& direction) {
  const std::size_t n = coefficients.raw(), errors = axis_count * motion_count + 3;
  std::vector<bool> takes_part(2 * errors, false);
  const auto curve_of = [&](std::size_t k) {
    return coefficients.error_of(k) + (k >= coefficients.half(0) ? errors : 0u);
  };
  for (std::size_t k = 0; k < n; ++k)
    if (std::abs(direction[k]) > harmless_share * std::sqrt(covariance[k * n + k])) takes_part[curve_of(k)] = true;
  for (std::size_t k = 0; k < n; ++k)
    if (!takes_part[curve_of(k)]) direction[k] = 0.0;
}

}  // namespace

struct LinearSolution::Factors {
  Coefficients coefficients;
  std::size_t raw_columns = 0;
  Scaled scaled;
  MatrixXd nulls;       ///< orthonormal null directions of the scaled columns; may have no column
  MatrixXd directions;  ///< the null directions as they were given
  Eigen::LLT<MatrixXd> cholesky;

  bool has_factor() const { return cholesky.info() == Eigen::Success; }
  VectorXd beside_nulls(VectorXd v) const {
    if (nulls.cols() > 0) v -= nulls * (nulls.transpose() * v);
    return v;
  }
  VectorXd solve(const VectorXd& right) const { return beside_nulls(cholesky.solve(beside_nulls(right))); }
  VectorXd kept_part(std::vector<double> raw) const {
    coefficients.turn_vector(raw);
    VectorXd part(static_cast<Index>(scaled.kept.size()));
    for (std::size_t k = 0; k < scaled.kept.size(); ++k) part[static_cast<Index>(k)] = raw[scaled.kept[k]];
    return part;
  }
  /// Free coefficients as raw ones, other columns as they are.
  std::vector<double> raw_of(const VectorXd& part) const {
    const std::size_t free = coefficients.free();
    const std::size_t others = scaled.kept.size() - free;
    std::vector<double> raw = coefficients.raw_of({part.data() + others, free});
    raw.resize(raw_columns, 0.0);
    for (std::size_t k = 0; k < others; ++k) raw[scaled.kept[k]] = part[static_cast<Index>(k)];
    return raw;
  }
  /// Of the inverse of the scaled matrix the last rows and columns. The inverse of S + N Nᵀ is that and N Nᵀ.
  MatrixXd inverse_end(Index count) const {
    MatrixXd w = cholesky.matrixLLT().bottomRightCorner(count, count).triangularView<Eigen::Lower>();
    invert_lower(w);
    MatrixXd inverse = square_of_lower(w);
    if (nulls.cols() > 0) inverse -= nulls.bottomRows(count) * nulls.bottomRows(count).transpose();
    return inverse;
  }
};

LinearSolution::LinearSolution(const Coefficients& coefficients, NormalEquations equations, NullDirections nulls)
    : factors_(std::make_unique<Factors>(Factors{coefficients, equations.columns, {}, {}, {}, {}})) {
  Factors& f = *factors_;
  f.scaled = scaled(coefficients, std::move(equations));
  const Index n = f.scaled.matrix.rows(), count = static_cast<Index>(nulls.size());
  f.nulls.resize(n, count);
  f.directions.resize(n, count);
  for (Index k = 0; k < count; ++k) {
    f.directions.col(k) = Eigen::Map<const VectorXd>(nulls[static_cast<std::size_t>(k)].data(), n);
    f.nulls.col(k) = f.directions.col(k).cwiseQuotient(f.scaled.scale).normalized();
  }
  if (count == 0) {
    f.cholesky.compute(f.scaled.matrix);
    return;
  }
  f.nulls = numeric::pivoted_orthonormal_basis(f.nulls);
  const MatrixXd along = f.nulls.transpose() * f.scaled.matrix;
  const MatrixXd corner = along * f.nulls + MatrixXd::Identity(count, count);
  const MatrixXd cross = f.nulls * along;
  const MatrixXd full = f.scaled.matrix - cross - cross.transpose() + f.nulls * corner * f.nulls.transpose();
  f.cholesky.compute(full);
}

LinearSolution::~LinearSolution() = default;
LinearSolution::LinearSolution(LinearSolution&&) noexcept = default;
LinearSolution& LinearSolution::operator=(LinearSolution&&) noexcept = default;

bool LinearSolution::is_doubtful() const {
  return !factors_->has_factor() || !(factors_->cholesky.rcond() > null_most);
}

std::size_t LinearSolution::columns() const { return factors_->raw_columns; }
std::size_t LinearSolution::unknowns() const { return factors_->scaled.kept.size(); }
std::size_t LinearSolution::null_directions() const { return static_cast<std::size_t>(factors_->nulls.cols()); }

double LinearSolution::condition() const {
  const Factors& f = *factors_;
  const Index n = f.scaled.matrix.rows();  // the eigenvalue 1 of null directions lies between the extremes
  const double most = largest_eigenvalue(
      n, [&](const VectorXd& v) -> VectorXd { return f.cholesky.matrixL() * (f.cholesky.matrixU() * v); });
  const double least_inverse =
      largest_eigenvalue(n, [&](const VectorXd& v) -> VectorXd { return f.cholesky.solve(v); });
  return std::sqrt(most * least_inverse);
}

std::vector<double> LinearSolution::step(std::vector<double> raw_gradient) const {
  const Factors& f = *factors_;
  const VectorXd right = f.scaled.scale.cwiseProduct(f.kept_part(std::move(raw_gradient)));
  return f.raw_of(f.scaled.scale.cwiseProduct(f.solve(right)));
}

std::vector<double> LinearSolution::coefficient_covariance() const {
  const Factors& f = *factors_;
  const auto free = static_cast<Index>(f.coefficients.free());
  const MatrixXd inverse = f.inverse_end(free);
  const VectorXd scale = f.scaled.scale.tail(free);
  std::vector<double> covariance(f.coefficients.free() * f.coefficients.free());
  for (Index i = 0; i < free; ++i)
    for (Index k = 0; k < free; ++k)
      covariance[static_cast<std::size_t>(i * free + k)] = scale[i] * scale[k] * inverse(k, i);
  std::vector<double> raw = f.coefficients.raw_covariance(covariance);
  for (std::size_t i = 0; i < f.coefficients.raw(); ++i) {
    double& variance = raw[i * f.coefficients.raw() + i];
    variance = std::max(0.0, variance);  // rounding leaves ±1e-16 along null directions
  }
  return raw;
}

/// Of the inverse (L Lᵀ)⁻¹ the block of columns E is YᵀY with L Y = E: of a few blocks at once, so that each number of
/// L is read once for all.
std::vector<Matrix3> LinearSolution::blocks(std::span<const std::size_t> columns) const {
  constexpr std::size_t at_once = 10;
  constexpr Index width = 3;
  const Factors& f = *factors_;
  std::vector<Matrix3> blocks;
  for (std::size_t begin = 0; begin < columns.size(); begin += at_once) {
    const std::span<const std::size_t> some = columns.subspan(begin, std::min(at_once, columns.size() - begin));
    std::vector<Index> first;
    for (const std::size_t column : some)
      first.push_back(static_cast<Index>(std::ranges::find(f.scaled.kept, column) - f.scaled.kept.begin()));
    MatrixXd y = MatrixXd::Zero(f.scaled.matrix.rows(), width * static_cast<Index>(some.size()));
    for (std::size_t b = 0; b < some.size(); ++b)
      y.block<width, width>(first[b], width * static_cast<Index>(b)).setIdentity();
    f.cholesky.matrixL().solveInPlace(y);
    for (std::size_t b = 0; b < some.size(); ++b) {
      const auto own = y.middleCols<width>(width * static_cast<Index>(b));
      Eigen::Matrix3d inverse = own.transpose() * own;
      if (f.nulls.cols() > 0) {  // a matrix without columns has no first entry
        const auto nulls = f.nulls.middleRows<width>(first[b]);
        inverse -= nulls * nulls.transpose();
      }
      Matrix3& block = blocks.emplace_back();
      for (Index i = 0; i < width; ++i)
        for (Index k = 0; k < width; ++k)
          block[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
              f.scaled.scale[first[b] + i] * f.scaled.scale[first[b] + k] * inverse(i, k);
    }
  }
  return blocks;
}

NullDirections LinearSolution::null_basis() const {
  NullDirections basis;
  for (Index k = 0; k < factors_->directions.cols(); ++k)
    basis.emplace_back(factors_->directions.col(k).begin(), factors_->directions.col(k).end());
  return basis;
}

std::vector<std::vector<double>> LinearSolution::unseen() const {
  const Factors& f = *factors_;
  std::vector<std::vector<double>> directions;
  if (f.directions.cols() == 0) return directions;
  const std::vector<double> covariance = coefficient_covariance();
  for (Index k = 0; k < f.directions.cols(); ++k) {
    const VectorXd direction = f.directions.col(k);
    std::vector<double> raw = f.raw_of(direction);
    raw.resize(f.coefficients.raw());
    keep_what_takes_part(f.coefficients, covariance, raw);
    double squares = 0.0;
    for (const double x : raw) squares += x * x;
    if (squares < 1e-20 * direction.squaredNorm()) continue;
    for (double& x : raw) x /= std::sqrt(squares);
    directions.push_back(std::move(raw));
  }
  return directions;
}

std::vector<std::size_t> LinearSolution::unseen_errors() const {
  std::set<std::size_t> errors;
  for (const std::vector<double>& direction : unseen())
    for (std::size_t k = 0; k < direction.size(); ++k)
      if (std::abs(direction[k]) > told_most) errors.insert(factors_->coefficients.error_of(k));
  return {errors.begin(), errors.end()};
}

NullDirections null_directions(const Coefficients& coefficients, NormalEquations equations) {
  const Scaled s = scaled(coefficients, std::move(equations));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(s.matrix);
  const VectorXd& values = solver.eigenvalues();  // ascending
  NullDirections nulls;
  for (Index k = 0; k < values.size() && values[k] < null_most; ++k) {
    const double deviation = 1.0 / std::sqrt(std::max(values[k], rounded_zero));
    const VectorXd direction = deviation * s.scale.cwiseProduct(solver.eigenvectors().col(k));
    nulls.emplace_back(direction.begin(), direction.end());
  }
  return nulls;
}

LinearSolution linear_solution(const Problem& problem, const State& state, const NormalEquations& equations) {
  LinearSolution solution(problem.coefficients, equations);
  NullDirections nulls;
  if (solution.is_doubtful())
    nulls = null_directions(problem.coefficients,
                            normal_equations(problem, sights(problem, with_stations_joined(problem, state))));
  if (problem.penalty != nullptr)
    return LinearSolution(problem.coefficients, problem.penalty->added_to(equations), std::move(nulls));
  if (nulls.empty()) return solution;
  return LinearSolution(problem.coefficients, equations, std::move(nulls));
}

}  // namespace axiometry::volumetric::detail
