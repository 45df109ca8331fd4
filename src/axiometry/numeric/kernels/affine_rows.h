// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "axiometry/numeric/kernels/affine_rows_kernel_types.h"
#include "axiometry/numeric/rows.h"
#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// Many rows, each a constant and a few multiples of other rows: y_r = c_r + Σ a_rk x_k for every trial. So readings
/// come from the draws that act on them.
///
/// Rounded after each product and each sum, in the order of the terms: ((c + a₁x₁) + a₂x₂) + …, on every target.
/// In single precision, constants and factors are rounded to it first.
class AffineRows {
 public:
  struct Term {
    std::size_t source = 0;  ///< k, a row of the input
    double factor = 0.0;     ///< a_rk
  };
  struct Row {
    double constant = 0.0;  ///< c_r
    std::vector<Term> terms;
  };

  explicit AffineRows(std::span<const Row> rows);

  std::size_t row_count() const { return constants_.size(); }
  std::size_t source_count() const { return source_count_; }  ///< rows of input that are read: the largest k, and one

  /// Contract: `sources` and `rows` hold so many rows and trials. Unless they do not overlap they are the same table,
  /// and a row takes none of those that are replaced but its own.
  void apply(Rows<const double> sources, Rows<double> rows, std::size_t trials,
             VectorTarget target = best_vector_target()) const;
  void apply(Rows<const float> sources, Rows<float> rows, std::size_t trials,
             VectorTarget target = best_vector_target()) const;

 private:
  std::size_t source_count_ = 0;
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint32_t> sources_;
  std::vector<double> constants_;
  std::vector<double> factors_;
  std::vector<float> constants_single_;
  std::vector<float> factors_single_;
};

/// row −= Σ f_k x_k, one product after the other, x_k the rows of the sources: the same bits on every target. Contract:
/// as many sources as factors, of at least as many trials as the row has.
void subtract_products(std::span<const double> factors, Rows<const double> sources, std::span<double> row,
                       VectorTarget target = best_vector_target());

/// The same of every row of a table, the factors of a row after those of the one before. Contract: whole rows, as many
/// factors for each, and both tables hold so many trials.
void subtract_products(std::span<const double> factors, Rows<const double> sources, Rows<double> rows,
                       std::size_t trials, VectorTarget target = best_vector_target());

}  // namespace axiometry::numeric
