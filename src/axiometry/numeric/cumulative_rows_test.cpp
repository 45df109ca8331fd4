// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/cumulative_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {
namespace {

constexpr std::size_t rows_of_test = 23;

/// Ascending numbers with many that are alike, in rows of so many.
std::vector<float> ascending_rows(std::size_t numbers) {
  std::vector<double> uniform(rows_of_test * numbers);
  fill_uniform({3, 1, numbers}, uniform);
  std::vector<float> values;
  for (double u : uniform) values.push_back(static_cast<float>(std::round(u * 64.0) / 64.0));
  for (std::size_t r = 0; r < rows_of_test; ++r) std::ranges::sort(std::span(values).subspan(r * numbers, numbers));
  return values;
}

TEST(CumulativeRows, CountAsUpperBoundOnEveryTarget) {
  for (std::size_t numbers : {1u, 2u, 7u, 8u, 9u, 15u, 16u, 17u, 63u, 64u, 65u, 72u, 73u, 116u, 127u, 128u, 200u}) {
    const std::vector<float> values = ascending_rows(numbers);
    CumulativeRows table(rows_of_test, numbers);
    for (std::size_t k = 0; k < values.size(); ++k) table.set(k / numbers, k % numbers, values[k]);
    std::vector<float> asked;
    std::vector<std::uint32_t> rows;
    for (std::size_t k = 0; k <= 256; ++k)  // on the numbers, between them, below and above all
      for (std::size_t r = 0; r < rows_of_test; ++r) {
        asked.push_back(static_cast<float>(k) / 256.0F);
        rows.push_back(static_cast<std::uint32_t>((r * 7 + k) % rows_of_test));
      }
    const auto expected = [&](std::size_t row, float x) {
      const auto own = std::span(values).subspan(row * numbers, numbers);
      return static_cast<std::uint32_t>(std::ranges::upper_bound(own, x) - own.begin());
    };
    for (VectorTarget target : available_vector_targets()) {
      SCOPED_TRACE(std::string(vector_target_name(target)) + ", " + std::to_string(numbers));
      std::vector<std::uint32_t> found(asked.size());
      table.count_up_to(asked, rows, found, target);
      for (std::size_t k = 0; k < asked.size(); ++k) ASSERT_EQ(found[k], expected(rows[k], asked[k])) << asked[k];
      table.count_up_to(std::span(asked).first(rows_of_test), {}, found, target);
      for (std::size_t r = 0; r < rows_of_test; ++r) ASSERT_EQ(found[r], expected(r, asked[r]));
    }
  }
}

}  // namespace
}  // namespace axiometry::numeric
