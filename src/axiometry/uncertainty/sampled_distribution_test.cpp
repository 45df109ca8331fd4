// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/sampled_distribution.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::uncertainty {
namespace {

/// A million trials of a distribution without their scatter, in cells of equal width.
template <typename Probability>
SampledDistribution exact(Probability probability_below, double lower, double upper) {
  constexpr int cells = 16'384;
  std::vector<SampledDistribution::Cell> result;
  std::uint64_t below = 0;
  for (int i = 1; i <= cells; ++i) {
    const double begin = lower + (upper - lower) * (i - 1) / cells, end = lower + (upper - lower) * i / cells;
    const auto up_to = static_cast<std::uint64_t>(std::llround(1e12 * probability_below(end)));
    if (up_to > below) result.push_back({begin, end, below, up_to - below});
    below = up_to;
  }
  return SampledDistribution(std::move(result));
}

TEST(SampledDistribution, InterpolatesWithinACell) {
  const SampledDistribution d({{0.0, 1.0, 0, 10}, {2.0, 4.0, 10, 30}});
  EXPECT_EQ(d.trials(), 40u);
  EXPECT_DOUBLE_EQ(d.quantile(0.0), 0.0);
  EXPECT_DOUBLE_EQ(d.quantile(0.125), 0.5);
  EXPECT_DOUBLE_EQ(d.quantile(0.25), 1.0);
  EXPECT_DOUBLE_EQ(d.quantile(0.625), 3.0);
  EXPECT_DOUBLE_EQ(d.quantile(1.0), 4.0);
  EXPECT_DOUBLE_EQ(d.probability_below(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(d.probability_below(0.5), 0.125);
  EXPECT_DOUBLE_EQ(d.probability_below(1.5), 0.25);
  EXPECT_DOUBLE_EQ(d.probability_below(3.0), 0.625);
  EXPECT_DOUBLE_EQ(d.probability_below(9.0), 1.0);
}

TEST(SampledDistribution, HasNarrowEnoughCellsForANormalDistribution) {
  const auto d = exact(numeric::normal_probability, -6.2, 6.2);
  EXPECT_NEAR(d.quantile(0.975), 1.959963984540054, 3e-7);
  EXPECT_NEAR(d.symmetric_interval(0.99).lower, -2.5758293035489, 3e-7);
  EXPECT_NEAR(d.fourth_moment(0.0), 3.0, 1e-5);
  // √(p(1 − p)/M)/g(ξ), here for M = 1e12.
  EXPECT_NEAR(d.quantile_error(0.975) / (std::sqrt(0.025 * 0.975) / 0.05844507 * 1e-6), 1.0, 0.01);
}

TEST(SampledDistribution, FindsTheShortestIntervalOfSkewDistributions) {
  // Gamma with shape 2 and lognormal with σ = 0.5. Validation: least length found with another program.
  const auto gamma = exact([](double x) { return 1.0 - (1.0 + x) * std::exp(-x); }, 0.0, 25.0);
  EXPECT_NEAR(gamma.shortest_interval(0.95).lower, 0.042363, 2e-3);
  EXPECT_NEAR(gamma.shortest_interval(0.95).upper, 4.765168, 2e-2);
  const auto lognormal = exact([](double x) { return numeric::normal_probability(2 * std::log(x)); }, 1e-3, 15.0);
  EXPECT_NEAR(lognormal.shortest_interval(0.95).lower, 0.261652, 2e-3);
  EXPECT_NEAR(lognormal.shortest_interval(0.95).upper, 2.318079, 2e-2);
}

TEST(SampledDistribution, KeepsTheEndWhereTheDensityBeginsAtItsLargest) {
  const auto exponential = exact([](double x) { return 1.0 - std::exp(-x); }, 0.0, 25.0);
  EXPECT_DOUBLE_EQ(exponential.shortest_interval(0.95).lower, 0.0);
  EXPECT_NEAR(exponential.shortest_interval(0.95).upper, -std::log(0.05), 1e-5);
}

}  // namespace
}  // namespace axiometry::uncertainty
