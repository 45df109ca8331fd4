// SPDX-License-Identifier: Apache-2.0
#pragma once

// The search of cumulative_rows.h for one target; compiled once for each (vector_target.h). No branch depends on the
// numbers: half of them would be guessed wrong.
#include "axiometry/numeric/cumulative_kernel_types.h"
#include "axiometry/numeric/lanes.h"

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {
namespace {

/// How many of a block's numbers are at most x.
[[gnu::always_inline]] inline uint32_t count_in_block(const float* block, float x) {
#if defined(__AVX2__)
  static_assert(cumulative_block == 8);
  const __m256 below = _mm256_cmp_ps(_mm256_loadu_ps(block), _mm256_set1_ps(x), _CMP_LE_OQ);
  return static_cast<uint32_t>(__builtin_popcount(static_cast<unsigned>(_mm256_movemask_ps(below))));
#else
  uint32_t count = 0;
  for (size_t k = 0; k < cumulative_block; ++k) count += block[k] <= x ? 1u : 0u;
  return count;
#endif
}

void count_up_to(const CumulativeView& view, const uint32_t* rows, const float* numbers, size_t count,
                 uint32_t* found) {
  for (size_t i = 0; i < count; ++i) {
    const float* const row = view.values + (rows == nullptr ? i : rows[i]) * view.stride;
    const float x = numbers[i];
    size_t blocks = 0;
    for (size_t k = 0; k < view.ends; k += cumulative_block) blocks += count_in_block(row + k, x);
    const size_t below = blocks * cumulative_block;
    found[i] = static_cast<uint32_t>(below) + count_in_block(row + view.ends + below, x);
  }
}

}  // namespace

extern const CumulativeKernel cumulative_kernel;
const CumulativeKernel cumulative_kernel = {count_up_to};

}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
