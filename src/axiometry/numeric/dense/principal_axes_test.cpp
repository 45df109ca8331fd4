// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/dense/principal_axes.h"

#include <gtest/gtest.h>

namespace axiometry::numeric {
namespace {

TEST(PrincipalAxes, GiveTheMatrixBack) {
  const std::vector<double> matrix = {4, 1, 0, 1, 3, 1, 0, 1, 2};
  const PrincipalAxes axes = principal_axes(matrix, 3);
  EXPECT_LT(axes.values[0], axes.values[2]);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k) sum += axes.values[k] * axes.axis(k)[i] * axes.axis(k)[j];
      EXPECT_NEAR(sum, matrix[i * 3 + j], 1e-12);
    }
}

}  // namespace
}  // namespace axiometry::numeric
