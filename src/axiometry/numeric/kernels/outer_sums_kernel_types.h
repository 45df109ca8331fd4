// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// Two neighbouring blocks, or one and itself, of numbers that lie in the same rows.
struct OuterBlocks {
  const double* left = nullptr;  ///< beginning of the first row
  std::size_t left_count = 0;
  const double* right = nullptr;
  std::size_t right_count = 0;
  std::size_t rows = 0;
  std::size_t stride = 0;  ///< distance from one row to the next
};

struct OuterSumsKernel {
  /// to[i · columns + k] += Σ_n left_n[i] right_n[k]; of a block and itself, what lies below the diagonal may be left
  /// out.
  void (*add)(const OuterBlocks& blocks, double* to, std::size_t columns);
};

/// The one for this target; contract: it is available.
const OuterSumsKernel& outer_sums_kernel_of(VectorTarget target);

}  // namespace axiometry::numeric
