// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/singles/single_means.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace axiometry::app {
namespace {

DirectionMean drawn_mean(std::mt19937_64& random, std::size_t runs, double sd) {
  std::normal_distribution<double> normal(0.0, sd);
  double sum = 0.0, squares = 0.0;
  for (std::size_t r = 0; r < runs; ++r) {
    const double x = normal(random);
    sum += x;
    squares += x * x;
  }
  const auto n = static_cast<double>(runs);
  return {sum / n, std::sqrt((squares - sum * sum / n) / (n - 1.0)), runs};
}

/// Of runs that scatter alike about 0, 95.45 % of means and halves lie within 2 u; each by its own s, 82 % of two runs.
TEST(SingleMeans, OfFewRunsHoldTheTruth) {
  std::mt19937_64 random(5);
  for (const std::size_t runs : {2u, 3u, 5u})
    for (const bool both : {true, false}) {
      int means = 0, halves = 0, all = 0;
      for (int set = 0; set < 600; ++set) {
        std::vector<PositionMeans> positions;
        for (int i = 0; i < 6; ++i) {
          PositionMeans& p = positions.emplace_back(PositionMeans{100.0 * i, drawn_mean(random, runs, 0.7), {}});
          if (both) p.down = drawn_mean(random, runs, 0.7);
        }
        const auto read = single_means({0, 1}, positions, {});
        ASSERT_TRUE(read);
        for (std::size_t i = 0; i < 6; ++i, ++all) {
          means += std::abs(read->motion.values[i]) <= 2.0 * read->motion.u[i];
          if (both) halves += std::abs(read->motion.reversal->halves[i]) <= 2.0 * read->motion.reversal->u[i];
        }
      }
      EXPECT_NEAR(static_cast<double>(means) / all, 0.955, 0.017) << runs << both;
      if (both) EXPECT_NEAR(static_cast<double>(halves) / all, 0.955, 0.017) << runs;
    }
}

TEST(SingleMeans, TakeTheScatterOfAPositionThatIsUnlikeTheOthersAndSayWhich) {
  std::vector<PositionMeans> positions;
  for (int i = 0; i < 6; ++i) positions.push_back({100.0 * i, DirectionMean{0.0, 0.5 + 0.1 * (i % 2), 5}, {}});
  const auto alike = single_means({0, 1}, positions, {});
  EXPECT_NEAR(alike->motion.u[0], std::sqrt((0.25 + 0.36) / 2.0 / 5.0) * 2.1097 / 2.0, 1e-3)
      << "k of 24 degrees of freedom";
  EXPECT_TRUE(alike->remarks.empty());
  positions[2].up->s = 6.0;
  const auto read = single_means({0, 1}, positions, {});
  EXPECT_NEAR(read->motion.u[2], 6.0 / std::sqrt(5.0) * 2.869 / 2.0, 1e-3) << "its own, with k of 4";
  EXPECT_NEAR(read->motion.u[0], std::sqrt((2.0 * 0.25 + 3.0 * 0.36) / 5.0 / 5.0) * 2.133 / 2.0, 1e-3)
      << "of the others, with k of 20";
  ASSERT_EQ(read->remarks.size(), 1u);
  EXPECT_TRUE(read->remarks[0].ends_with(": 200 mm ↑")) << read->remarks[0];
  positions[4].up->s = 7.0;
  EXPECT_TRUE(single_means({0, 1}, positions, {})->remarks[0].ends_with(": 200 mm ↑, 400 mm ↑"))
      << "none hides another";
}

TEST(SingleMeans, SayWhereDirectionsScatterUnlikeEachOther) {
  std::vector<PositionMeans> positions;
  for (int i = 0; i < 6; ++i) positions.push_back({100.0 * i, DirectionMean{0.0, 0.5, 3}, DirectionMean{0.0, 2.0, 3}});
  const auto read = single_means({0, 3}, positions, {});
  ASSERT_EQ(read->remarks.size(), 1u);
  EXPECT_EQ(
      read->remarks[0],
      "runs moving up scatter by 0.5 µrad (standard deviation), those moving down by 2 µrad: each direction has "
      "the uncertainty of its own runs");
  EXPECT_NEAR(read->motion.reversal->covariances[0], (0.25 - 4.0) / 3.0 / 4.0 * std::pow(2.2314 / 2.0, 2), 1e-3)
      << "k of 12 degrees of freedom";
}

}  // namespace
}  // namespace axiometry::app
