// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/walk.h"

#include <gtest/gtest.h>

#include <string>

namespace axiometry::nc {
namespace {

Plan plan_of(TestCycle cycle, std::size_t runs, std::size_t warm_up_runs = 0) {
  Plan plan;
  plan.cycle = cycle;
  for (double x : {0.0, 10.0}) plan.targets.push_back(Position::native(x));
  plan.runs = runs;
  plan.warm_up_runs = warm_up_runs;
  plan.overrun = Position::native(5.0);
  plan.feed = 1000.0;
  return plan;
}

/// "-5 | 5x(0↑ 10↑ …)"
std::string text_of(const std::vector<RepeatedMoves>& list) {
  std::string text;
  for (const RepeatedMoves& stretch : list) {
    if (!text.empty()) text += " | ";
    if (stretch.times > 1) text += std::to_string(stretch.times) + "x(";
    for (std::size_t k = 0; k < stretch.moves.size(); ++k) {
      if (k > 0) text += " ";
      text += std::to_string(static_cast<int>(stretch.moves[k].to.in_native()));
      if (stretch.moves[k].approach) text += arrow(stretch.moves[k].approach->direction);
    }
    if (stretch.times > 1) text += ") to run " + std::to_string(stretch.last_run + 1);
  }
  return text;
}

TEST(Walk, FoldsRunsOfTheStandardCycleWhole) {
  EXPECT_EQ(text_of(walk(plan_of(TestCycle::standard, 5), 99)), "-5 | 5x(0↑ 10↑ 15 10↓ 0↓ -5) to run 5");
  EXPECT_EQ(text_of(walk(plan_of(TestCycle::unidirectional, 3), 99)), "-5 | 3x(0↑ 10↑ -5) to run 3");
}

TEST(Walk, FoldsWarmUpRuns) {
  EXPECT_EQ(text_of(walk(plan_of(TestCycle::unidirectional, 3, 2), 99)),
            "-5 | 2x(15 -5) to run 1 | 3x(0↑ 10↑ -5) to run 3");
}

TEST(Walk, FoldsTheRunsAtATargetButTheLastWhereThatEndsElsewhere) {
  EXPECT_EQ(text_of(walk(plan_of(TestCycle::step, 5), 99)),
            "-5 | 4x(0↑ 5 0↓ -5) to run 4 | 0↑ 5 0↓ | 4x(10↑ 15 10↓ 5) to run 4 | 10↑ 15 10↓ -5");
  EXPECT_EQ(text_of(walk(plan_of(TestCycle::pilgrim, 3), 99)),
            "-5 | 2x(0↑ -5) to run 2 | 0↑ | 2x(10↑ 5) to run 2 | 10↑ | 3x(15 10↓) to run 3 | "
            "2x(0↓ 5) to run 2 | 0↓ -5");
}

TEST(Walk, WritesOutWhatIsBeyondTheLimitOfLoops) {
  EXPECT_EQ(text_of(walk(plan_of(TestCycle::step, 3), 1)),
            "-5 | 2x(0↑ 5 0↓ -5) to run 2 | 0↑ 5 0↓ 10↑ 15 10↓ 5 10↑ 15 10↓ 5 10↑ 15 10↓ -5");
  EXPECT_EQ(text_of(walk(plan_of(TestCycle::standard, 2), 0)), "-5 | 0↑ 10↑ 15 10↓ 0↓ -5 0↑ 10↑ 15 10↓ 0↓ -5");
}

TEST(Walk, IsThePlanWhenItIsReadOneAfterAnother) {
  for (TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional})
    for (std::size_t runs = 1; runs < 7; ++runs)
      for (std::size_t limit : {0, 1, 3, 99}) {
        const Plan plan = plan_of(cycle, runs, runs % 3);
        std::vector<Position> unfolded, expected;
        for (const RepeatedMoves& stretch : walk(plan, limit))
          for (std::size_t k = 0; k < stretch.times; ++k)
            for (const PlannedMove& move : stretch.moves) unfolded.push_back(move.to);
        for (const PlannedMove& move : moves(plan)) expected.push_back(move.to);
        EXPECT_EQ(unfolded, expected) << cycle_name(cycle) << runs;
      }
}

TEST(Walk, WritesOutASequenceThatAllButRepeats) {
  Plan plan = plan_of(TestCycle::user_defined, 3);
  plan.targets.push_back(Position::native(20.0));
  for (std::size_t run : {0u, 1u, 2u})
    for (std::size_t target : {0u, 1u, 2u})
      if (run == 0 || target < 2 || run == 2) plan.sequence.push_back({target, Direction::up, run});
  EXPECT_EQ(text_of(walk(plan, 99)), "-5 | 0↑ 10↑ 20↑ -5 0↑ 10↑ -5 0↑ 10↑ 20↑ -5");
}

}  // namespace
}  // namespace axiometry::nc
