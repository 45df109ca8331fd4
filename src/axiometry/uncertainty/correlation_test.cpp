// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/correlation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace axiometry::uncertainty {
namespace {

std::string error_of(std::size_t size, std::vector<double> matrix) {
  const auto correlation = Correlation::make(size, std::move(matrix));
  return correlation ? "no error" : correlation.error().message;
}

TEST(Correlation, NamesTheEigenvalueOfAMatrixThatContradictsItself) {
  // Two of the three pairs say that what remains is positive. λ = 1 − 2·0.9.
  EXPECT_EQ(
      error_of(3, {1, 0.9, 0.9, 0.9, 1, -0.9, 0.9, -0.9, 1}),
      "found a correlation matrix with the eigenvalue -0.8, expected none below zero: its coefficients contradict "
      "each other");
}

TEST(Correlation, RefusesCoefficientsThatAreNone) {
  EXPECT_EQ(error_of(2, {1, 1.5, 1.5, 1}), "found the correlation 1.5 of inputs 1 and 2, expected one from -1 to 1");
  EXPECT_EQ(error_of(2, {1, 0.5, 0.4, 1}), "found the correlations 0.5 and 0.4 of inputs 1 and 2, expected the same");
  EXPECT_EQ(error_of(2, {1, 0.5, 0.5, 2}), "found the correlation 2 of input 2 with itself, expected 1");
  EXPECT_EQ(error_of(2, {1, NAN, NAN, 1}), "found the correlation nan of inputs 1 and 2, expected one from -1 to 1");
}

TEST(Correlation, RefusesCoefficientsThatWereRoundedTooFar) {
  // The outputs of GUM H.2 as printed there, with three decimals.
  EXPECT_EQ(error_of(3, {1, -0.588, -0.485, -0.588, 1, 0.993, -0.485, 0.993, 1}),
            "found a correlation matrix with the eigenvalue -0.000454, expected none below zero: its coefficients "
            "contradict each other");
}

TEST(Correlation, HasAFactorThatGivesItBack) {
  const std::vector<double> matrices[] = {
      {1, -0.355, 0.858, -0.355, 1, -0.645, 0.858, -0.645, 1},
      {1, 1, -1, 1, 1, -1, -1, -1, 1},  // rank 1
      {1, 0, 0, 0, 1, 0, 0, 0, 1},
      {1, 0.5, 0, 0.5, 1, 0.8660254037844386, 0, 0.8660254037844386, 1},  // rank 2
  };
  for (const auto& matrix : matrices) {
    const auto r = Correlation::make(3, matrix);
    ASSERT_TRUE(r) << r.error().message;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        double product = 0.0;
        for (std::size_t k = 0; k <= j; ++k) product += r->factor_row(i)[k] * r->factor_row(j)[k];
        EXPECT_NEAR(product, (*r)(i, j), 1e-12) << i << " " << j;
      }
  }
}

TEST(Correlation, KnowsWhoIsCorrelated) {
  const auto r = Correlation::make(3, {1, 0, 0.5, 0, 1, 0, 0.5, 0, 1}).value();
  EXPECT_TRUE(r.any());
  EXPECT_TRUE(r.correlated(0));
  EXPECT_FALSE(r.correlated(1));
  EXPECT_FALSE(Correlation::none(4).any());
  EXPECT_EQ(Correlation::none(0).size(), 0u);
}

}  // namespace
}  // namespace axiometry::uncertainty
