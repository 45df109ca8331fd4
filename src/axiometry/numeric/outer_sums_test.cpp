// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/outer_sums.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace axiometry::numeric {
namespace {

TEST(OuterSums, AreTheSameOnEveryTargetAndAsWrittenOut) {
  constexpr std::size_t columns = 60;
  std::vector<double> values(37);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::sin(1.0 + 7.0 * static_cast<double>(k));
  const RowPiece pieces[] = {
      {2, 24, values.data()}, {30, 3, values.data() + 24}, {40, 9, values.data() + 27}, {59, 1, values.data() + 36}};
  std::vector<double> dense(columns, 0.0);
  for (const RowPiece& p : pieces)
    for (std::size_t k = 0; k < p.count; ++k) dense[p.first + k] = p.values[k];
  std::vector<double> expected(columns * columns, 0.25);
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t k = i; k < columns; ++k) {
      const double factor = 1.7 * dense[i];
      expected[i * columns + k] += factor * dense[k];
    }
  for (const VectorTarget target : available_vector_targets()) {
    std::vector<double> matrix(columns * columns, 0.25);
    outer_sums_kernel_of(target).add({pieces, 4, 1.7}, matrix.data(), columns);
    for (std::size_t i = 0; i < columns; ++i)
      for (std::size_t k = i; k < columns; ++k)
        EXPECT_EQ(matrix[i * columns + k], expected[i * columns + k]) << vector_target_name(target);
  }
}

TEST(OuterSums, OfFourRowsAreTheSameOnEveryTargetAndThoseOfEachRow) {
  constexpr std::size_t columns = 60, values_each = 37;
  std::vector<double> values(4 * values_each);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::sin(1.0 + 7.0 * static_cast<double>(k));
  std::vector<std::vector<RowPiece>> pieces;
  for (std::size_t n = 0; n < 4; ++n) {
    const double* own = values.data() + n * values_each;
    pieces.push_back({{2, 24, own}, {30, 3, own + 24}, {40, 9, own + 27}, {59, 1, own + 36}});
  }
  std::array<PiecedRow, 4> rows;
  std::vector<double> expected(columns * columns, 0.25);
  for (std::size_t n = 0; n < 4; ++n) {
    rows[n] = {pieces[n].data(), 4, 1.7 + static_cast<double>(n)};
    add_outer(pieces[n], rows[n].weight, expected, columns);
  }
  std::vector<double> first;
  for (const VectorTarget target : available_vector_targets()) {
    std::vector<double> matrix(columns * columns, 0.25);
    outer_sums_kernel_of(target).add_four(rows.data(), matrix.data(), columns);
    if (first.empty()) first = matrix;
    for (std::size_t i = 0; i < columns; ++i)
      for (std::size_t k = i; k < columns; ++k) {
        EXPECT_EQ(matrix[i * columns + k], first[i * columns + k]) << vector_target_name(target);
        EXPECT_NEAR(matrix[i * columns + k], expected[i * columns + k], 1e-14);
      }
  }
}

}  // namespace
}  // namespace axiometry::numeric
