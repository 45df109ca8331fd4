// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/motion_walk.h"

#include <gmock/gmock.h>

#include <cmath>

#include "axiometry/simulation/test_support.h"

namespace axiometry::simulation {
namespace {

using testing::HasSubstr;

constexpr VirtualMotion bow_of_5{.size = 5.0};

Plan walked_plan() {
  Plan plan = plan_of({0.0, 50.0, 100.0}, 2);
  plan.warm_up_runs = 3;
  return plan;
}

MotionWalk walk_of(const VirtualMotion& motion, std::uint64_t seed = 7) {
  auto walk = MotionWalk::make(walked_plan(), motion, seed);
  EXPECT_TRUE(walk);
  return *std::move(walk);
}

/// Of a rest, so many that little of the noise is left.
double mean_at(MotionWalk& walk, std::size_t rest) {
  constexpr std::uint64_t samples = 10'000;
  double sum = 0.0;
  for (std::uint64_t k = 0; k < samples; ++k) sum += walk.at(walk.rests()[rest].middle_s(), k).value;
  return sum / static_cast<double>(samples);
}

TEST(MotionWalk, TheTruthIsABowOverASlopeAndAnotherOnTheWayBack) {
  const Plan plan = walked_plan();
  EXPECT_DOUBLE_EQ(true_motion(bow_of_5, plan, 0.0, Direction::up), 0.0);
  EXPECT_DOUBLE_EQ(true_motion(bow_of_5, plan, 50.0, Direction::up), 5.0 * 1.3) << "the bow and half the slope";
  EXPECT_DOUBLE_EQ(true_motion(bow_of_5, plan, 100.0, Direction::up), 5.0 * 0.6);
  EXPECT_NEAR(true_motion(bow_of_5, plan, 50.0, Direction::down), 5.0 * 1.45, 1e-12);
}

TEST(MotionWalk, RestsAtEachApproachInTheOrderOfThePlanWithoutItsWarmUp) {
  const Plan plan = walked_plan();
  MotionWalk walk = walk_of(bow_of_5);
  const auto order = approaches(plan);
  ASSERT_EQ(walk.rests().size(), order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& rest = walk.rests()[k];
    EXPECT_NEAR(rest.to_s - rest.from_s, plan.dwell.in_s(), 1e-12);
    const auto moment = walk.at(rest.middle_s(), k);
    EXPECT_TRUE(moment.at_rest);
    EXPECT_NEAR(moment.position_mm, plan.targets[order[k].target].in_native(), 5e-4);
    EXPECT_FALSE(walk.at(rest.to_s + 0.05, k).at_rest) << "it has gone on";
  }
  EXPECT_LT(walk.rests().front().from_s, 10.0) << "the warm-up alone would take longer";
  EXPECT_GE(walk.duration_s(), walk.rests().back().to_s);
}

TEST(MotionWalk, WhatIsReadIsTheTruthWithinWhatIsStatedOfIt) {
  const Plan plan = walked_plan();
  MotionWalk walk = walk_of(bow_of_5);
  const auto order = approaches(plan);
  double sum = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double truth = true_motion(bow_of_5, plan, plan.targets[order[k].target].in_native(), order[k].direction);
    const double off = mean_at(walk, k) - truth;
    EXPECT_LT(std::abs(off), 5.0 * 0.03 * bow_of_5.size);
    sum += off * off;
  }
  const double spread = std::sqrt(sum / static_cast<double>(order.size()));
  EXPECT_GT(spread, 0.2 * 0.03 * bow_of_5.size) << "approaches scatter";
  EXPECT_LT(spread, 2.5 * 0.03 * bow_of_5.size);
}

TEST(MotionWalk, ASeedGivesTheSameReadingsInWhateverOrderTheyAreAsked) {
  MotionWalk one = walk_of(bow_of_5), two = walk_of(bow_of_5), other = walk_of(bow_of_5, 8);
  const double late = one.at(12.0, 5000).value, early = one.at(12.0, 17).value;
  EXPECT_EQ(two.at(12.0, 17).value, early);
  EXPECT_EQ(two.at(12.0, 5000).value, late);
  EXPECT_NE(other.at(12.0, 17).value, early);
}

TEST(MotionWalk, TheTriggerRisesOnceWithinEachRest) {
  MotionWalk walk = walk_of(bow_of_5);
  std::size_t rises = 0;
  bool on = false;
  for (std::uint64_t k = 0; static_cast<double>(k) / 100.0 <= walk.duration_s(); ++k) {
    const auto moment = walk.at(static_cast<double>(k) / 100.0, k);
    EXPECT_TRUE(moment.at_rest || !moment.trigger);
    rises += moment.trigger && !on ? 1 : 0;
    on = moment.trigger;
  }
  EXPECT_EQ(rises, walk.rests().size());
}

TEST(MotionWalk, ADriftMovesTheReadingsByHalfTheSizeOverThePlan) {
  MotionWalk still = walk_of(bow_of_5), drifting = walk_of({.size = 5.0, .drifts = true});
  const std::size_t last = still.rests().size() - 1;
  const double share = still.rests()[last].middle_s() / still.duration_s();
  EXPECT_NEAR(mean_at(drifting, last) - mean_at(still, last), 2.5 * share, 1e-9);
  EXPECT_NEAR(mean_at(drifting, 0) - mean_at(still, 0), 2.5 * still.rests()[0].middle_s() / still.duration_s(), 1e-9);
}

TEST(MotionWalk, OneTargetSpansNoError) {
  const auto walk = MotionWalk::make(plan_of({10.0}), bow_of_5, 1);
  ASSERT_FALSE(walk);
  EXPECT_THAT(walk.error().message, HasSubstr("found a plan of one target"));
}

}  // namespace
}  // namespace axiometry::simulation
