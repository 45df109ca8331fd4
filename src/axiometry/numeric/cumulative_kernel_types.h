// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// Numbers of a row that are compared at once.
inline constexpr std::size_t cumulative_block = 8;

/// Rows of cumulative_rows.h as the kernel reads them: first the last number of every block but the last, then the
/// blocks; both are filled up to whole blocks with ∞.
struct CumulativeView {
  const float* values = nullptr;
  std::size_t stride = 0;
  std::size_t ends = 0;  ///< numbers before the blocks, a multiple of cumulative_block
};

struct CumulativeKernel {
  /// Of each number how many of its row's are at most as large; its row is rows[i], or i where `rows` is null.
  void (*count_up_to)(const CumulativeView& view, const std::uint32_t* rows, const float* numbers, std::size_t count,
                      std::uint32_t* found);
};

/// The one for this target; contract: it is available.
const CumulativeKernel& cumulative_kernel_of(VectorTarget target);

}  // namespace axiometry::numeric
