// SPDX-License-Identifier: Apache-2.0
#pragma once

// The sums of outer_sums.h for one target; compiled once for each (vector_target.h).
#include "axiometry/numeric/kernels/lanes.h"
#include "axiometry/numeric/kernels/outer_sums_kernel_types.h"

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {
namespace {

/// A tile of `height` rows of the result from i on and `width` vectors from k on: it stays in registers for all rows.
template <size_t height, size_t width>
[[gnu::always_inline]] inline void add_tile(const OuterBlocks& blocks, size_t i, size_t k, double* to, size_t columns) {
  Doubles sums[height][width];
#pragma GCC unroll 4
  for (size_t a = 0; a < height; ++a)
#pragma GCC unroll 4
    for (size_t b = 0; b < width; ++b) sums[a][b] = load<Doubles>(to + (i + a) * columns + k + b * lanes<Doubles>);
  const double *left = blocks.left + i, *right = blocks.right + k;
  for (size_t n = 0; n < blocks.rows; ++n, left += blocks.stride, right += blocks.stride) {
    Doubles values[width];
#pragma GCC unroll 4
    for (size_t b = 0; b < width; ++b) values[b] = load<Doubles>(right + b * lanes<Doubles>);
#pragma GCC unroll 4
    for (size_t a = 0; a < height; ++a) {
      const double factor = left[a];
#pragma GCC unroll 4
      for (size_t b = 0; b < width; ++b) sums[a][b] += factor * values[b];
    }
  }
#pragma GCC unroll 4
  for (size_t a = 0; a < height; ++a)
#pragma GCC unroll 4
    for (size_t b = 0; b < width; ++b) store(to + (i + a) * columns + k + b * lanes<Doubles>, sums[a][b]);
}

/// `height` rows of the result from i on.
template <size_t height>
[[gnu::always_inline]] inline void add_rows(const OuterBlocks& blocks, size_t i, double* to, size_t columns) {
  constexpr size_t wide = 2;
  size_t k = blocks.left == blocks.right ? i / lanes<Doubles> * lanes<Doubles> : 0;
  for (; k + wide * lanes<Doubles> <= blocks.right_count; k += wide * lanes<Doubles>)
    add_tile<height, wide>(blocks, i, k, to, columns);
  for (; k + lanes<Doubles> <= blocks.right_count; k += lanes<Doubles>) add_tile<height, 1>(blocks, i, k, to, columns);
  for (; k < blocks.right_count; ++k)
    for (size_t a = 0; a < height; ++a) {
      double sum = to[(i + a) * columns + k];
      for (size_t n = 0; n < blocks.rows; ++n)
        sum += blocks.left[n * blocks.stride + i + a] * blocks.right[n * blocks.stride + k];
      to[(i + a) * columns + k] = sum;
    }
}

void add(const OuterBlocks& blocks, double* to, size_t columns) {
  constexpr size_t high = 4;
  size_t i = 0;
  for (; i + high <= blocks.left_count; i += high) add_rows<high>(blocks, i, to, columns);
  for (; i < blocks.left_count; ++i) add_rows<1>(blocks, i, to, columns);
}

}  // namespace

extern const OuterSumsKernel outer_sums_kernel;
const OuterSumsKernel outer_sums_kernel = {add};

}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
