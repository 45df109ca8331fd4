// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/correlation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/numeric/dense/dense.h"

namespace axiometry::uncertainty {
namespace {

constexpr double eigenvalue_slack = 1e-12;  // coefficients are rarely known to twelve digits, rounding is far below
constexpr double pivot_slack = 1e-14;

Result<void> check_coefficients(std::size_t size, std::span<const double> matrix) {
  for (std::size_t i = 0; i < size; ++i) {
    if (const double r = matrix[i * size + i]; r != 1.0)
      return fail(fmt::format("found the correlation {} of input {} with itself, expected 1", r, i + 1));
    for (std::size_t j = 0; j < i; ++j) {
      const double r = matrix[i * size + j];
      if (!(std::abs(r) <= 1.0))
        return fail(
            fmt::format("found the correlation {} of inputs {} and {}, expected one from -1 to 1", r, j + 1, i + 1));
      if (const double mirrored = matrix[j * size + i]; mirrored != r)
        return fail(fmt::format("found the correlations {} and {} of inputs {} and {}, expected the same",
                                format_exact(mirrored), format_exact(r), j + 1, i + 1));
    }
  }
  return {};
}

double smallest_eigenvalue(std::size_t size, const std::vector<double>& matrix) {
  const auto n = static_cast<Eigen::Index>(size);
  const Eigen::MatrixXd symmetric = Eigen::Map<const Eigen::MatrixXd>(matrix.data(), n, n);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

/// Cholesky's factor. In a matrix without negative eigenvalues what stands below a pivot of zero is zero too.
std::vector<double> cholesky(std::size_t size, const std::vector<double>& matrix) {
  std::vector<double> factor(size * size, 0.0);
  const auto remainder = [&](std::size_t i, std::size_t j) {
    double sum = matrix[i * size + j];
    for (std::size_t k = 0; k < j; ++k) sum -= factor[i * size + k] * factor[j * size + k];
    return sum;
  };
  for (std::size_t j = 0; j < size; ++j) {
    const double pivot = remainder(j, j);
    if (pivot <= pivot_slack) continue;
    factor[j * size + j] = std::sqrt(pivot);
    for (std::size_t i = j + 1; i < size; ++i) factor[i * size + j] = remainder(i, j) / factor[j * size + j];
  }
  return factor;
}

}  // namespace

Correlation::Correlation(std::size_t size, std::vector<double> matrix)
    : size_(size), matrix_(std::move(matrix)), factor_(cholesky(size_, matrix_)) {}

Correlation Correlation::none(std::size_t size) {
  std::vector<double> matrix(size * size, 0.0);
  for (std::size_t i = 0; i < size; ++i) matrix[i * size + i] = 1.0;
  return Correlation(size, std::move(matrix));
}

Result<Correlation> Correlation::make(std::size_t size, std::vector<double> matrix) {
  AXIOMETRY_CONTRACT(matrix.size() == size * size);
  AXIOMETRY_TRY_VOID(check_coefficients(size, matrix));
  if (size > 1)
    if (const double smallest = smallest_eigenvalue(size, matrix); smallest < -eigenvalue_slack)
      return fail(fmt::format(
          "found a correlation matrix with the eigenvalue {:.3g}, expected none below zero: its coefficients "
          "contradict each other",
          smallest));
  return Correlation(size, std::move(matrix));
}

bool Correlation::correlated(std::size_t i) const {
  for (std::size_t j = 0; j < size_; ++j)
    if (j != i && (*this)(i, j) != 0.0) return true;
  return false;
}

bool Correlation::any() const {
  for (std::size_t i = 0; i < size_; ++i)
    if (correlated(i)) return true;
  return false;
}

}  // namespace axiometry::uncertainty
