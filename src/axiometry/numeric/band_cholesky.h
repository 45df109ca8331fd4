// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace axiometry::numeric {

/// A symmetric positive definite matrix of n rows with two diagonals on each side of its own, as sums of neighbours'
/// squares make it, and what solves it in a time proportional to n: A = L·Lᵀ, L with as many diagonals
/// (Golub & Van Loan, Matrix Computations, 4.3.5).
class BandMatrix {
 public:
  static constexpr std::size_t width = 2;

  explicit BandMatrix(std::size_t rows) : rows_(rows) {}
  std::size_t rows() const { return rows_.size(); }

  /// A(i, i − back), and with it its mirror image; back ≤ width, back ≤ i.
  double& at(std::size_t i, std::size_t back) { return rows_[i][back]; }

  /// Adds weight · r·rᵀ of a row r that is `values` from column `first` on and 0 elsewhere; at most width + 1 values.
  void add_square(std::size_t first, std::span<const double> values, double weight);

  /// The factor L in the same shape; nothing where the matrix is not positive definite.
  std::optional<BandMatrix> cholesky() const;

  /// Of a factor: L·Lᵀ x = b, x in place of b.
  void solve(std::span<double> b) const;

 private:
  std::vector<std::array<double, width + 1>> rows_;  // columns i, i − 1, i − 2 of row i
};

}  // namespace axiometry::numeric
