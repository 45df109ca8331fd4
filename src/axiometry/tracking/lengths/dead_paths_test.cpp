// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/dead_paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace axiometry::tracking {
namespace {

const std::vector<Position> targets = {Position::native(0.0), Position::native(10.0), Position::native(20.0)};
using enum Direction;

TEST(DeadPaths, AreTiedByTheApproachesThatBothPartsHave) {
  // By hand: target 1 has 1 and 6, target 2 has 2 and 8 (differences 5 and 6), target 3 one reading alone.
  const std::vector<TiedSample> samples = {
      {0, up, 1.0, 1.0, 0}, {1, up, 2.0, 1.0, 0}, {0, up, 6.0, 1.0, 1}, {1, up, 8.0, 1.0, 1}, {2, up, 9.0, 1.0, 1}};
  const DeadPathFit fit = fit_dead_paths(samples, targets, 2);
  EXPECT_TRUE(fit.by_approach);
  EXPECT_NEAR(fit.stretches[1].shift_mm, 5.5, 1e-12);
  EXPECT_EQ(fit.stretches[1].ties, 2u);
  EXPECT_TRUE(fit.stretches[1].tied);
  // Residuals ±0.25 four times, one freedom: s = 0.5; the mean of two differences of two readings has u = s.
  EXPECT_EQ(fit.degrees_of_freedom, 1u);
  EXPECT_NEAR(fit.scatter_mm, 0.5, 1e-12);
  EXPECT_NEAR(fit.stretches[1].uncertainty_mm, 0.5, 1e-12);
  EXPECT_EQ(fit.stretches[0].shift_mm, 0.0);
  EXPECT_EQ(fit.stretches[0].uncertainty_mm, 0.0);
}

TEST(DeadPaths, LeaveOutliersOutOfTheTies) {
  const std::vector<TiedSample> samples = {
      {0, up, 1.0, 1.0, 0}, {0, up, 99.0, 1.0, 0, false}, {0, up, 3.0, 1.0, 1}, {1, up, 5.0, 1.0, 1}};
  EXPECT_NEAR(fit_dead_paths(samples, targets, 2).stretches[1].shift_mm, 2.0, 1e-12);
}

TEST(DeadPaths, AreTiedOverTheReversalWhereOnlyTargetsAreCommon) {
  // Up 1, 2, 3, then after a break of 5 down over the same targets but for the first, which is met both ways before.
  const std::vector<TiedSample> samples = {{0, up, 1.0, 1.0, 0}, {0, down, 1.3, 1.0, 0}, {1, up, 2.0, 1.0, 0},
                                           {2, up, 3.0, 1.0, 0}, {2, down, 8.3, 1.0, 1}, {1, down, 7.3, 1.0, 1}};
  const DeadPathFit fit = fit_dead_paths(samples, targets, 2);
  EXPECT_FALSE(fit.by_approach);
  EXPECT_TRUE(fit.stretches[1].tied);
  EXPECT_NEAR(fit.stretches[1].shift_mm, 5.0, 1e-12);
}

TEST(DeadPaths, AreSetWithoutAStepWhereNothingTies) {
  // The whole way up, a break, the whole way down: reversal error and dead path are one number.
  const std::vector<TiedSample> samples = {
      {0, up, 1.0, 1.0, 0}, {1, up, 2.0, 1.0, 0}, {1, down, 7.0, 1.0, 1}, {0, down, 6.0, 1.0, 1}};
  const DeadPathFit fit = fit_dead_paths(samples, targets, 2);
  EXPECT_FALSE(fit.stretches[1].tied);
  EXPECT_NEAR(fit.stretches[1].shift_mm, 5.0, 1e-12);
}

TEST(DeadPaths, LeaveOutliersOutOfTheLevelsWhereNothingTies) {
  const std::vector<TiedSample> samples = {{0, up, 1.0, 1.0, 0},
                                           {1, up, 2.0, 1.0, 0},
                                           {1, down, 7.0, 1.0, 1},
                                           {0, down, 6.0, 1.0, 1},
                                           {0, down, 106.0, 1.0, 1, false}};
  EXPECT_NEAR(fit_dead_paths(samples, targets, 2).stretches[1].shift_mm, 5.0, 1e-12);
}

TEST(DeadPaths, TakeTheLevelOfAPartThatIsAllOutliers) {
  const std::vector<TiedSample> samples = {{0, up, 1.0, 1.0, 0}, {1, up, 2.0, 1.0, 0}, {1, down, 7.0, 1.0, 1, false}};
  EXPECT_NEAR(fit_dead_paths(samples, targets, 2).stretches[1].shift_mm, 5.0, 1e-12);
}

}  // namespace
}  // namespace axiometry::tracking
