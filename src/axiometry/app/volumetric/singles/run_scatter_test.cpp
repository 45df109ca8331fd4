// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/singles/run_scatter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/support/statistics_of_trials.h"

namespace axiometry::app {
namespace {

/// Runs of one mean about 0: how widely they scatter, and by what the first of them is false.
struct Drawn {
  double sd = 1.0;
  double false_by = 0.0;
};

DirectionMean drawn(std::mt19937_64& random, std::size_t runs, const Drawn& how) {
  std::normal_distribution<double> normal(0.0, how.sd);
  double sum = 0.0, squares = 0.0;
  for (std::size_t r = 0; r < runs; ++r) {
    const double x = normal(random) + (r == 0 ? how.false_by : 0.0);
    sum += x;
    squares += x * x;
  }
  const auto n = static_cast<double>(runs);
  return {sum / n, std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1.0)), runs};
}

/// Of many sets of eleven positions in both directions: how many means lie within 2 u.
struct Held {
  double unlike = 0.0, others_up = 0.0, others_down = 0.0;
  double u_others = 0.0;  ///< mean of √n u of the others
};

Held held(std::size_t runs, std::size_t unlike, const Drawn& how, double sd_down = 1.0) {
  std::mt19937_64 random(17);
  constexpr int sets = 2000;
  Held within;
  for (int set = 0; set < sets; ++set) {
    std::vector<PositionMeans> positions;
    for (std::size_t i = 0; i < 11; ++i)
      positions.push_back({100.0 * static_cast<double>(i), drawn(random, runs, i < unlike ? how : Drawn{}),
                           drawn(random, runs, {sd_down})});
    const RunScatter scatter = run_scatter(positions);
    for (std::size_t i = 0; i < 11; ++i) {
      const double u_up = std::sqrt(scatter.means[i][0].variance), u_down = std::sqrt(scatter.means[i][1].variance);
      const double up = std::abs(positions[i].up->mean) <= 2.0 * u_up ? 1.0 : 0.0;
      (i < unlike ? within.unlike : within.others_up) += up;
      within.others_down += std::abs(positions[i].down->mean) <= 2.0 * u_down ? 1.0 : 0.0;
      if (i >= unlike) within.u_others += u_up * std::sqrt(static_cast<double>(runs));
    }
  }
  const double others = sets * static_cast<double>(11 - unlike);
  return {within.unlike / (sets * static_cast<double>(unlike)), within.others_up / others,
          within.others_down / (11 * sets), within.u_others / others};
}

/// 95.45 % is what 2 u says; docs/theory/volumetric.md has these figures of numpy.
TEST(RunScatter, HoldsRunsThatScatterAlike) {
  for (const std::size_t runs : {2u, 3u, 5u}) {
    const Held alike = held(runs, 0, {});
    EXPECT_NEAR(alike.others_up, 0.954, 0.006) << runs;
    EXPECT_NEAR(alike.others_down, 0.954, 0.006) << runs;
    EXPECT_LT(alike.u_others, 1.10) << runs;
  }
}

TEST(RunScatter, OfFalseReadingsThatWouldHideEachOtherHoldsThemAndLeavesTheOthersAlone) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  for (const std::size_t runs : {2u, 3u, 5u})
    for (const std::size_t unlike : {1u, 2u, 4u}) {
      const Held two = held(runs, unlike, {1.0, 20.0});
      EXPECT_GT(two.unlike, 0.99) << runs << ' ' << unlike;
      EXPECT_NEAR(two.others_up, 0.954, 0.007) << runs << ' ' << unlike;
      EXPECT_LT(two.u_others, 1.11) << runs << ' ' << unlike << ": a pool with them in it has 3 and more";
    }
}

TEST(RunScatter, OfOneFalseReadingThatTwoRunsHardlyTellHoldsMostAllTheSame) {
  EXPECT_GT(held(2, 1, {1.0, 6.0}).unlike, 0.88) << "44 % where only what surely stands out has its own s";
  EXPECT_GT(held(3, 1, {1.0, 6.0}).unlike, 0.93);
  EXPECT_GT(held(5, 1, {1.0, 6.0}).unlike, 0.95);
}

TEST(RunScatter, HoldsPositionsThatScatterTenTimesAsMuch) {
  const Held of_three = held(3, 2, {10.0, 0.0}), of_five = held(5, 2, {10.0, 0.0});
  EXPECT_GT(of_three.unlike, 0.90);
  EXPECT_GT(of_five.unlike, 0.945);
  EXPECT_LT(of_three.u_others, 1.09);
  EXPECT_LT(of_five.u_others, 1.05);
}

TEST(RunScatter, HoldsBothDirectionsWhereOneScattersThreeTimesAsMuch) {
  for (const std::size_t runs : {2u, 3u, 5u}) {
    const Held unlike = held(runs, 0, {}, 3.0);
    EXPECT_GT(unlike.others_down, runs == 2 ? 0.925 : 0.945) << runs << ": 0.86 by an s of both";
    EXPECT_LT(unlike.others_up, 0.97) << runs << ": all of them by an s of both";
  }
}

DirectionMean mean_of(double s, std::size_t runs) { return {0.0, s, runs}; }

TEST(RunScatter, ReadingsOfACoarseStepAreNoReasonToTrustTheRest) {
  // Two runs read to 1 µm: 0 and 1 once, 0 and 3 once; all others agree to the last digit.
  std::vector<PositionMeans> positions;
  for (int i = 0; i < 8; ++i) positions.push_back({100.0 * i, mean_of(0.0, 2), {}});
  positions[2].up->s = std::sqrt(0.5);
  RunScatter scatter = run_scatter(positions);
  EXPECT_FALSE(scatter.means[2][0].stands_out);
  EXPECT_GT(scatter.means[0][0].variance, 0.5 / 8.0 / 2.0);
  positions[5].up->s = std::sqrt(450.0);  // 0 and 30
  scatter = run_scatter(positions);
  EXPECT_TRUE(scatter.means[5][0].stands_out);
  EXPECT_FALSE(scatter.means[2][0].stands_out);
  EXPECT_GE(scatter.means[0][0].variance, 1.0 / 12.0 / 2.0) << "never less than rounding to 1 µm leaves";
}

TEST(RunScatter, OfOneRunIsNone) {
  std::vector<PositionMeans> positions = {{0.0, DirectionMean{1.0, {}, 1}, mean_of(0.5, 3)},
                                          {10.0, DirectionMean{1.0, {}, 1}, mean_of(0.5, 3)}};
  const RunScatter scatter = run_scatter(positions);
  EXPECT_EQ(scatter.means[0][0].variance, 0.0);
  EXPECT_NEAR(std::sqrt(scatter.means[0][1].variance), 0.5 / std::sqrt(3.0) * 2.869 / 2.0, 1e-3);
  EXPECT_FALSE(scatter.by_direction);
}

}  // namespace
}  // namespace axiometry::app
