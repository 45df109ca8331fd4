// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/kernels/outer_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace axiometry::numeric {
namespace {

/// Places behind those that are asked for keep what they hold.
TEST(OuterSums, AreTheSameOnEveryTargetAndAsWrittenOut) {
  constexpr std::size_t columns = 60, stride = 59;
  std::vector<double> values(70 * stride);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::sin(1.0 + 7.0 * static_cast<double>(k));
  for (const std::size_t left_count : {1u, 3u, 6u, 8u, 24u, 29u})
    for (const std::size_t right_count : {1u, 3u, 6u, 8u, 13u, 24u, 30u})
      for (const std::size_t rows : {1u, 2u, 5u, 70u}) {
        const OuterBlocks blocks{values.data(), left_count, values.data() + left_count, right_count, rows, stride};
        std::vector<double> expected(left_count * columns, 0.25);
        for (std::size_t n = 0; n < rows; ++n)
          for (std::size_t i = 0; i < left_count; ++i)
            for (std::size_t k = 0; k < right_count; ++k) {
              const double product = blocks.left[n * stride + i] * blocks.right[n * stride + k];
              expected[i * columns + k] += product;
            }
        for (const VectorTarget target : available_vector_targets()) {
          std::vector<double> sums(left_count * columns, 0.25);
          outer_sums_kernel_of(target).add(blocks, sums.data(), columns);
          EXPECT_EQ(sums, expected) << vector_target_name(target) << " " << left_count << " × " << right_count;
        }
      }
}

TEST(OuterSums, OfABlockAndItselfAreRightFromTheDiagonalOn) {
  constexpr std::size_t columns = 40, stride = 31, rows = 9;
  std::vector<double> values(rows * stride);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::cos(2.0 + 5.0 * static_cast<double>(k));
  for (const std::size_t count : {1u, 3u, 8u, 24u, 30u}) {
    const OuterBlocks blocks{values.data(), count, values.data(), count, rows, stride};
    for (const VectorTarget target : available_vector_targets()) {
      std::vector<double> sums(count * columns, 0.0);
      outer_sums_kernel_of(target).add(blocks, sums.data(), columns);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = i; k < count; ++k) {
          double expected = 0.0;
          for (std::size_t n = 0; n < rows; ++n) {
            const double product = values[n * stride + i] * values[n * stride + k];
            expected += product;
          }
          EXPECT_EQ(sums[i * columns + k], expected) << vector_target_name(target) << " " << count;
        }
    }
  }
}

}  // namespace
}  // namespace axiometry::numeric
