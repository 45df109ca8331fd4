// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/band_cholesky.h"

#include <gtest/gtest.h>

namespace axiometry::numeric {
namespace {

TEST(BandMatrix, SolvesWhatTheFullMatrixSolves) {
  // A = Σ r·rᵀ of neighbours, times x = (1, −2, 3, 0.5, 4).
  BandMatrix matrix(5);
  for (std::size_t i = 0; i < 5; ++i) matrix.add_square(i, std::array{1.0 + static_cast<double>(i)}, 1.0);
  for (std::size_t i = 0; i < 3; ++i) matrix.add_square(i, std::array{1.0, -2.0, 1.0}, 2.0);
  const std::array x{1.0, -2.0, 3.0, 0.5, 4.0};
  std::array<double, 5> b{};
  for (std::size_t i = 0; i < 5; ++i) b[i] = (1.0 + static_cast<double>(i)) * (1.0 + static_cast<double>(i)) * x[i];
  for (std::size_t i = 0; i < 3; ++i) {
    const double second = x[i] - 2.0 * x[i + 1] + x[i + 2];
    b[i] += 2.0 * second;
    b[i + 1] -= 4.0 * second;
    b[i + 2] += 2.0 * second;
  }
  const auto factor = matrix.cholesky();
  ASSERT_TRUE(factor);
  factor->solve(b);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(b[i], x[i], 1e-12);
}

TEST(BandMatrix, HasNoFactorWhereARowIsUndetermined) {
  BandMatrix matrix(2);
  matrix.add_square(0, std::array{1.0, -1.0}, 1.0);
  EXPECT_FALSE(matrix.cholesky());
}

TEST(BandMatrix, TakesASingleRow) {
  BandMatrix matrix(1);
  matrix.add_square(0, std::array{2.0}, 1.0);
  std::array b{8.0};
  matrix.cholesky()->solve(b);
  EXPECT_DOUBLE_EQ(b[0], 2.0);
}

}  // namespace
}  // namespace axiometry::numeric
