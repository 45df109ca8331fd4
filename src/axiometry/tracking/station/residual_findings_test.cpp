// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/residual_findings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "axiometry/numeric/distributions/special_functions.h"

namespace axiometry::tracking {
namespace {

TEST(FewResiduals, TellHowBadlyTheyAreKnown) {
  const auto one = few_residuals_finding(9.0, 1);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->id, "tracking-residuals-few");
  EXPECT_FALSE(one->serious);
  EXPECT_TRUE(one->message.contains("ν = 1 only: 95 % needs 12.7 times")) << one->message;
  EXPECT_TRUE(few_residuals_finding(10.1, 10)->message.contains("2.23 times"));
}

TEST(FewResiduals, SayNothingWhereNothingWasMultipliedOrManyTellIt) {
  EXPECT_FALSE(few_residuals_finding(1.0, 1));
  EXPECT_FALSE(few_residuals_finding(0.3, 2));
  EXPECT_FALSE(few_residuals_finding(40.0, 11));
  EXPECT_FALSE(few_residuals_finding(0.0, 0));
}

/// Readings that scatter three times as much as was stated: u is 1 times √(χ²/ν), and what is said of it is true.
TEST(FewResiduals, NeedTheirFactor) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, 3.0);
  for (const int nu : {1, 2, 5}) {
    const double k = numeric::student_t_quantile(0.975, nu);
    int told = 0, held = 0, held_by_two = 0;
    while (told < 4000) {
      double chi_squared = 0.0;
      for (int i = 0; i < nu; ++i) chi_squared += std::pow(normal(random), 2.0);
      const double error = std::abs(normal(random));
      if (!few_residuals_finding(chi_squared, static_cast<std::size_t>(nu))) continue;
      const double u = std::sqrt(chi_squared / nu);
      ++told;
      held += error <= k * u;
      held_by_two += error <= 2.0 * u;
    }
    EXPECT_GT(held, 0.94 * told) << nu;
    EXPECT_LT(held_by_two, 0.93 * told) << nu;
  }
}

}  // namespace
}  // namespace axiometry::tracking
