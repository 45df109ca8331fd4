// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/plan_pace.h"

#include <gtest/gtest.h>

#include "tests/support/made_up_recording.h"

namespace axiometry::capture {
namespace {

/// The approaches to the second target ↑ of four runs, and when they come at 1.3 times what the plan needs.
struct MadeUpPace {
  Plan plan = testing_support::made_up_plan(5, 4);
  std::vector<double> at_s;
  std::vector<std::size_t> second_up;
  PlanPace pace{plan};

  explicit MadeUpPace(std::size_t read) {
    double sum = 0.0;
    const auto all = approaches(plan);
    const auto times = planned_times_s(plan);
    for (std::size_t k = 0; k < all.size(); ++k) {
      at_s.push_back(sum += 1.3 * times[k]);
      if (all[k].target == 1 && all[k].direction == Direction::up) second_up.push_back(k);
    }
    for (std::size_t k = 0; k < read; ++k) pace.read(k, at_s[k], k > 0);
  }
  std::vector<std::size_t> from(std::size_t first) const {
    std::vector<std::size_t> some;
    for (const std::size_t k : second_up)
      if (k >= first) some.push_back(k);
    return some;
  }
};

TEST(PlanPace, KnowsTheRunByTheTimeAtThePaceOfTheProgram) {
  const MadeUpPace made(8);
  const auto left = made.from(8);
  ASSERT_EQ(left.size(), 3u);
  for (const std::size_t k : left) {
    const auto placed = made.pace.place(left, made.at_s[k] + 3.0);
    EXPECT_EQ(placed.approach, k);
    EXPECT_TRUE(placed.sure);
  }
}

TEST(PlanPace, TakesTheFirstWhereTheTimeFitsNone) {
  const MadeUpPace made(8);
  const auto left = made.from(8);
  const auto placed = made.pace.place(left, 0.5 * (made.at_s[left[0]] + made.at_s[left[1]]));
  EXPECT_EQ(placed.approach, left[0]);
  EXPECT_FALSE(placed.sure);
  EXPECT_FALSE(made.pace.place(left, made.at_s.back() + 1000.0).sure);
}

TEST(PlanPace, BelievesNoClockThatStoodStillWhileNothingCame) {
  const MadeUpPace made(8);
  const auto left = made.from(8);
  const auto placed = made.pace.place(left, made.at_s[7] + 0.1);
  EXPECT_EQ(placed.approach, left[0]);
  EXPECT_TRUE(placed.sure);
}

TEST(FullWays, CountsWaysOverAllOfAStretch) {
  FullWays ways(0.0, 100.0);
  for (const double place : {-5.0, 105.0, 50.0, 105.0, -5.0, 20.0}) ways.go(place);
  EXPECT_EQ(ways.count(), 2u);
}

}  // namespace
}  // namespace axiometry::capture
