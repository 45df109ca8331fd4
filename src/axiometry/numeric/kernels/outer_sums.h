// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/numeric/kernels/outer_sums_kernel_types.h"

/// Sums of products of the entries of rows, what normal equations are made of. Products and sums are rounded one by one
/// in the order of the rows, on every target alike.
namespace axiometry::numeric {

/// to[i · columns + k] += Σ_n left_n[i] right_n[k] for i < left_count, k < right_count. Of a block and itself, what
/// lies below the diagonal may be left out.
inline void add_outer_sums(const OuterBlocks& blocks, double* to, std::size_t columns) {
  static const OuterSumsKernel& kernel = outer_sums_kernel_of(best_vector_target());
  kernel.add(blocks, to, columns);
}

}  // namespace axiometry::numeric
