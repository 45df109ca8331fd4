// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "axiometry/numeric/outer_sums_kernel_types.h"

/// Normal equations of rows that are 0 but for a few pieces: Σ w a aᵀ. Products and sums are rounded one by one in the
/// order of the rows, on every target alike.
namespace axiometry::numeric {

/// Adds w a aᵀ to the upper triangle of a matrix by rows; entries below it may change. Contract: places rise and are
/// below `columns`.
inline void add_outer(std::span<const RowPiece> row, double weight, std::span<double> matrix, std::size_t columns) {
  static const OuterSumsKernel& kernel = outer_sums_kernel_of(best_vector_target());
  kernel.add({row.data(), row.size(), weight}, matrix.data(), columns);
}

/// The same of four rows at once; their products are added to each other first. Contract: pieces of the same places.
inline void add_outers(std::span<const PiecedRow, 4> rows, std::span<double> matrix, std::size_t columns) {
  static const OuterSumsKernel& kernel = outer_sums_kernel_of(best_vector_target());
  kernel.add_four(rows.data(), matrix.data(), columns);
}

}  // namespace axiometry::numeric
