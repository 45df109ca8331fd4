// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "axiometry/numeric/outer_sums_kernel_types.h"

/// Normal equations of rows that are 0 but for a few pieces: Σ w a aᵀ and Σ w a v. Products and sums are rounded one by
/// one in the order of the rows, on every target alike.
namespace axiometry::numeric {

/// Adds w a aᵀ to the upper triangle of a matrix by rows; entries below it may change. Contract: places rise and are
/// below `columns`.
inline void add_outer(std::span<const RowPiece> row, double weight, std::span<double> matrix, std::size_t columns) {
  static const OuterSumsKernel& kernel = outer_sums_kernel_of(best_vector_target());
  kernel.add({row.data(), row.size(), weight}, matrix.data(), columns);
}

/// Adds factor · a.
inline void add_times(std::span<const RowPiece> row, double factor, std::span<double> sum) {
  for (const RowPiece& piece : row)
    for (std::size_t k = 0; k < piece.count; ++k) sum[piece.first + k] += factor * piece.values[k];
}

}  // namespace axiometry::numeric
