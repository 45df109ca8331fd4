// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/base/result.h"

/// Correlation coefficients between input quantities (GUM 5.2).
namespace axiometry::uncertainty {

/// A matrix that some random quantities really have: symmetric, ones on the diagonal, no negative eigenvalue.
class Correlation {
 public:
  static Correlation none(std::size_t size);

  /// Rows one after another; contract: size × size numbers. Fails on a coefficient outside −1 to 1, a diagonal that is
  /// not 1, two coefficients of one pair that differ, and on a negative eigenvalue, which it names: such
  /// coefficients contradict each other. Eigenvalues down to −1e-12 are taken for zero.
  static Result<Correlation> make(std::size_t size, std::vector<double> matrix);

  std::size_t size() const { return size_; }
  double operator()(std::size_t i, std::size_t j) const { return matrix_[i * size_ + j]; }

  bool any() const;                      ///< a coefficient off the diagonal is not 0
  bool correlated(std::size_t i) const;  ///< any() of row i

  /// Row i of the lower triangular L with L Lᵀ = R, its first i + 1 numbers. Where R is singular, columns of L vanish.
  /// Correlated standard normal numbers are L z of independent ones z.
  std::span<const double> factor_row(std::size_t i) const { return std::span(factor_).subspan(i * size_, i + 1); }

 private:
  Correlation(std::size_t size, std::vector<double> matrix);

  std::size_t size_ = 0;
  std::vector<double> matrix_;
  std::vector<double> factor_;
};

}  // namespace axiometry::uncertainty
