// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace axiometry {
namespace {

Plan plan_of(TestCycle cycle, std::vector<double> targets, std::size_t runs) {
  Plan plan;
  plan.cycle = cycle;
  for (double x : targets) plan.targets.push_back(Position::native(x));
  plan.runs = runs;
  plan.overrun = Position::native(5.0);
  plan.feed = 1000.0;
  return plan;
}

/// "−5 0↑1 10↑1 …": where the axis goes, and what is read there.
std::string text_of(const std::vector<PlannedMove>& list) {
  std::string text;
  for (const PlannedMove& move : list) {
    text += text.empty() ? "" : " ";
    text += std::to_string(static_cast<int>(move.to.in_native()));
    if (move.approach) text += std::string(arrow(move.approach->direction)) + std::to_string(move.approach->run + 1);
  }
  return text;
}

TEST(Plan, StandardCycleRunsUpOverAllTargetsAndBeyondThenDown) {
  EXPECT_EQ(text_of(moves(plan_of(TestCycle::standard, {0, 10, 20}, 2))),
            "-5 0↑1 10↑1 20↑1 25 20↓1 10↓1 0↓1 -5 0↑2 10↑2 20↑2 25 20↓2 10↓2 0↓2 -5");
}

TEST(Plan, StepCycleFinishesEachTargetBeforeTheNext) {
  EXPECT_EQ(text_of(moves(plan_of(TestCycle::step, {0, 10}, 2))),
            "-5 0↑1 5 0↓1 -5 0↑2 5 0↓2 10↑1 15 10↓1 5 10↑2 15 10↓2 -5");
}

TEST(Plan, StepCycleBacksOffWhereTheNextTargetIsNearerThanTheOverrun) {
  EXPECT_EQ(text_of(moves(plan_of(TestCycle::step, {0, 2}, 1))), "-5 0↑1 5 0↓1 -3 2↑1 7 2↓1 -5");
}

TEST(Plan, PilgrimCycleTakesAllRunsUpThenAllRunsDown) {
  EXPECT_EQ(text_of(moves(plan_of(TestCycle::pilgrim, {0, 10}, 2))),
            "-5 0↑1 -5 0↑2 10↑1 5 10↑2 15 10↓1 15 10↓2 0↓1 5 0↓2 -5");
}

TEST(Plan, UnidirectionalCycleReturnsWithoutReadings) {
  EXPECT_EQ(text_of(moves(plan_of(TestCycle::unidirectional, {0, 10}, 2))), "-5 0↑1 10↑1 -5 0↑2 10↑2 -5");
}

TEST(Plan, UserDefinedCycleIsWalkedAsGiven) {
  Plan plan = plan_of(TestCycle::user_defined, {0, 10, 20}, 1);
  plan.sequence = {{2, Direction::down, 0}, {0, Direction::down, 0}, {1, Direction::up, 0}};
  EXPECT_EQ(text_of(moves(plan)), "-5 25 20↓1 0↓1 10↑1 -5");
}

TEST(Plan, WarmUpRunsGoThereAndBackBeforeTheFirstReading) {
  Plan plan = plan_of(TestCycle::unidirectional, {0, 10}, 1);
  plan.warm_up_runs = 2;
  EXPECT_EQ(text_of(moves(plan)), "-5 15 -5 15 -5 0↑1 10↑1 -5");
}

TEST(Plan, EveryApproachComesFromItsDirectionByAnOverrunOrStraightFromAnotherTarget) {
  for (TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional}) {
    const Plan plan = plan_of(cycle, {-3, 0, 1, 40, 44}, 3);
    const std::vector<PlannedMove> list = moves(plan);
    std::vector<Approach> read;
    for (std::size_t k = 1; k < list.size(); ++k) {
      EXPECT_NE(list[k].to, list[k - 1].to);
      if (!list[k].approach) continue;
      read.push_back(*list[k].approach);
      const double way = list[k].to.in_native() - list[k - 1].to.in_native();
      const bool up = list[k].approach->direction == Direction::up;
      EXPECT_EQ(way > 0.0, up) << cycle_name(cycle) << ", move " << k;
      const bool same_pass = list[k - 1].approach && list[k - 1].approach->direction == list[k].approach->direction;
      EXPECT_TRUE(same_pass || std::abs(way) >= 5.0) << cycle_name(cycle) << ", move " << k;
    }
    EXPECT_EQ(read, approaches(plan));
  }
}

TEST(Plan, RefusesWhatCannotBeWalkedAndSaysWhy) {
  const auto reason = [](auto spoil) {
    Plan plan = plan_of(TestCycle::standard, {0, 10, 20}, 2);
    spoil(plan);
    const auto sound = check_sound(plan);
    return sound ? std::string() : sound.error().message;
  };
  EXPECT_EQ(reason([](Plan&) {}), "");
  EXPECT_NE(reason([](Plan& p) { p.targets.clear(); }), "");
  EXPECT_EQ(reason([](Plan& p) { p.targets[1] = Position::native(20); }),
            "found target 3 at 20 after 20, expected ascending targets");
  EXPECT_NE(reason([](Plan& p) { p.targets[1] = Position::native(std::numeric_limits<double>::quiet_NaN()); }), "");
  EXPECT_NE(reason([](Plan& p) { p.runs = 0; }), "");
  EXPECT_NE(reason([](Plan& p) { p.overrun = Position::native(0); }), "");
  EXPECT_NE(reason([](Plan& p) { p.feed = -1; }), "");
  EXPECT_NE(reason([](Plan& p) { p.dwell = Duration::s(-1); }), "");
  // Lost in the rounding of a position, or of which a sum is no number.
  EXPECT_EQ(reason([](Plan& p) { p.overrun = Position::native(1e-300); }),
            "found an overrun of 1e-300, expected 1e-06 to 1000000000");
  EXPECT_EQ(reason([](Plan& p) { p.overrun = Position::native(1e308); }),
            "found an overrun of 1e+308, expected 1e-06 to 1000000000");
  EXPECT_EQ(reason([](Plan& p) { p.feed = 1e-300; }), "found a feed of 1e-300, expected 1e-06 to 1000000000");
  EXPECT_EQ(reason([](Plan& p) { p.dwell = Duration::s(1e308); }), "found a dwell of 1e+308 s, expected 0 to 1000000");
  EXPECT_EQ(reason([](Plan& p) {
              for (int k = 21; k < 200; ++k) p.targets.push_back(Position::native(k));
              p.runs = 10'000;
            }),
            "found 3640000 approaches, expected at most 1000000");
  EXPECT_NE(reason([](Plan& p) { p.cycle = TestCycle::user_defined; }), "");
  EXPECT_NE(reason([](Plan& p) { p.sequence = {{0, Direction::up, 0}}; }), "");
  EXPECT_EQ(reason([](Plan& p) {
              p.cycle = TestCycle::user_defined;
              p.sequence = {{0, Direction::up, 0}, {0, Direction::up, 0}};
            }),
            "found run 1 ↑ of target 1 a second time in the sequence, expected each once");
}

TEST(Plan, IsMadeForPositionsUnlessItSaysOtherwise) {
  Plan plan = plan_of(TestCycle::standard, {0, 10}, 1);
  EXPECT_TRUE(measures_positions(plan));
  EXPECT_EQ(errors_text(plan), "");
  plan.errors = {{'Y', 'X'}, {'A', 'X'}};
  EXPECT_FALSE(measures_positions(plan));
  EXPECT_EQ(errors_text(plan), "EYX, EAX");
  const auto refused = check_measures_positions(plan);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "found a plan made for EYX, EAX, expected one of positions");
  plan.errors.push_back({'X', 'X'});
  EXPECT_TRUE(measures_positions(plan)) << "EXX are the positions of X";
  EXPECT_TRUE(check_measures_positions(plan));
}

TEST(Plan, RefusesErrorsThatItsAxisDoesNotHave) {
  const auto fault = [](const std::string& axis, std::vector<MotionName> errors, AxisKind kind = AxisKind::linear) {
    Plan plan = plan_of(TestCycle::standard, {0, 10}, 1);
    plan.axis.name = axis;
    plan.axis.kind = kind;
    plan.errors = std::move(errors);
    const auto sound = check_sound(plan);
    return sound ? std::string() : sound.error().message;
  };
  EXPECT_EQ(fault("X", {{'Y', 'X'}, {'C', 'X'}}), "");
  EXPECT_EQ(fault("", {{'X', 'Y'}}), "");
  EXPECT_EQ(fault("Y", {{'Y', 'X'}}), "found the error EYX in a plan of the axis \"Y\", expected one of that axis");
  EXPECT_EQ(fault("", {{'Y', 'X'}, {'X', 'Y'}}), "found EYX and EXY in one plan, expected errors of one axis");
  EXPECT_EQ(fault("X", {{'Y', 'X'}, {'Z', 'X'}, {'Y', 'X'}}), "found EYX twice in a plan, expected each error once");
  EXPECT_EQ(fault("C", {{'Y', 'X'}}, AxisKind::rotary),
            "found EYX in a plan of a rotary axis or of a line in space, expected one of a linear axis");
}

}  // namespace
}  // namespace axiometry
