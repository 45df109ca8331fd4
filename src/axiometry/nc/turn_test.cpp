// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "axiometry/nc/dialect.h"
#include "axiometry/nc/script.h"
#include "tests/support/nc_controls.h"

namespace axiometry::nc {
namespace {

using testing_support::AxisRule;
using testing_support::NcSetup;

/// How rotary axes with rollover of these controls may be set.
const std::map<std::string, std::vector<AxisRule>> rollover_rules = {
    {"fagor", {AxisRule::shortest, AxisRule::by_sign, AxisRule::within_turn}},
    {"fanuc", {AxisRule::shortest, AxisRule::by_sign}},
    {"haas", {AxisRule::shortest, AxisRule::by_sign}},
    {"heidenhain", {AxisRule::within_turn}},
    {"iso6983", {AxisRule::shortest, AxisRule::by_sign, AxisRule::within_turn}},
    {"linuxcnc", {AxisRule::wrapped}},
    {"mazak-eia", {AxisRule::shortest, AxisRule::by_sign}},
    {"mitsubishi", {AxisRule::shortest, AxisRule::by_sign}},
    {"okuma", {AxisRule::shortest, AxisRule::by_sign, AxisRule::within_turn}},
    {"siemens-840d", {AxisRule::modulo}},
};

Plan rotary_plan(TestCycle cycle, std::vector<double> targets, double overrun) {
  Plan plan;
  plan.axis = {.name = "C", .kind = AxisKind::rotary};
  plan.cycle = cycle;
  for (double x : targets) plan.targets.push_back(Position::native(x));
  plan.runs = 3;
  plan.overrun = Position::native(overrun);
  plan.feed = 720;
  plan.dwell = Duration::s(1);
  plan.warm_up_runs = 2;
  if (cycle == TestCycle::user_defined) {
    using enum Direction;
    plan.sequence = {{1, up, 0}, {0, down, 0}, {1, up, 1}, {1, up, 2}, {0, down, 1}, {2, down, 0}, {2, down, 1}};
    plan.runs = 3;
  }
  return plan;
}

/// Tests of less than a turn, of one, through zero, and of several (5.3.4, 5.3.5).
std::vector<Plan> rotary_plans() {
  std::vector<Plan> list;
  for (TestCycle cycle :
       {TestCycle::standard, TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional, TestCycle::user_defined}) {
    list.push_back(rotary_plan(cycle, {0.1234, 45, 90.5}, 4));
    list.push_back(rotary_plan(cycle, {0, 90, 180, 270, 306.4577, 360}, 4));
    list.push_back(rotary_plan(cycle, {-181.25, 0, 359.9999}, 7.25));
    list.push_back(rotary_plan(cycle, {0, 360, 720, 1079.5, 1800}, 10));
    list.push_back(rotary_plan(cycle, {-3600.5, -3600, 725.001}, 0.25));
  }
  return list;
}

std::string turned_program(const Dialect& dialect, const Plan& plan, const ProgramOptions& options) {
  const auto program = dialect.write({&plan, 1}, options);
  EXPECT_TRUE(program) << dialect.id << ": " << (program ? "" : program.error().message);
  return program ? *program : "";
}

/// What the axis really does, by one rule of its control, from wherever it stood: after the first move, which is less
/// than a turn, every way of the plan in its direction and length, however many moves it takes.
void expect_turned(std::string_view dialect, const std::string& program, const Plan& plan, NcSetup setup) {
  const testing_support::Trace trace = testing_support::run_program(dialect, program, setup);
  const std::vector<PlannedMove> planned = moves(plan);
  ASSERT_FALSE(trace.visits.empty());
  const double zero = trace.visits[0].position - planned[0].to.in_native();
  ASSERT_NEAR(std::remainder(zero, 360.0), 0.0, 1e-6) << "the first move goes to another angle";
  ASSERT_LT(std::abs(trace.visits[0].position - setup.start_deg), 360.0);
  std::size_t k = 1;
  for (std::size_t visit = 1; visit < trace.visits.size(); ++visit) {
    ASSERT_LT(k, planned.size()) << "more moves than planned";
    const double from = planned[k - 1].to.in_native() + zero, to = planned[k].to.in_native() + zero;
    const auto& at = trace.visits[visit];
    ASSERT_NEAR(at.feed, plan.feed, 1e-9);
    if (std::abs(at.position - to) > 1e-6) {  // a part of the way
      ASSERT_GT((at.position - trace.visits[visit - 1].position) * (to - from), 0.0) << "move " << k << " turns round";
      ASSERT_LT((at.position - to) * (to - from), 0.0) << "move " << k << " goes too far, to " << at.position;
      ASSERT_EQ(at.dwells, 0u);
      continue;
    }
    ASSERT_NEAR(at.dwell_s, planned[k].approach ? plan.dwell.in_s() : 0.0, 1e-9) << "move " << k;
    ++k;
  }
  ASSERT_EQ(k, planned.size());
}

class EveryRollover : public testing::TestWithParam<const Dialect*> {};

TEST_P(EveryRollover, IsDrivenTheWayOfThePlanByEachRuleOfItsControlFromWhereverItStands) {
  const Dialect& dialect = *GetParam();
  for (const Plan& plan : rotary_plans())
    for (bool unrolled : {false, true}) {
      const std::string program = turned_program(dialect, plan, {.unrolled = unrolled, .rollover = true});
      for (AxisRule rule : rollover_rules.at(std::string(dialect.id)))
        for (double start : {0.0, 123.4567, 359.9, -4.0, 725.5})
          ASSERT_NO_FATAL_FAILURE(expect_turned(dialect.id, program, plan, {rule, start}))
              << "rule " << static_cast<int>(rule) << " from " << start << "\n"
              << program;
    }
}

/// Increments are what they are also where the operator was wrong about the rollover.
TEST_P(EveryRollover, IsDrivenLikewiseByIncrementsOrRefusedWhereTheAxisCountsOn) {
  const Dialect& dialect = *GetParam();
  for (const Plan& plan : rotary_plans()) {
    const std::string program = turned_program(dialect, plan, {.rollover = true});
    if (dialect.id == "siemens-840d") {  // names directions, which such an axis refuses
      ASSERT_THROW(testing_support::run_program(dialect.id, program, {AxisRule::counts_on, 12.0}), std::runtime_error);
      continue;
    }
    ASSERT_NO_FATAL_FAILURE(expect_turned(dialect.id, program, plan, {AxisRule::counts_on, 12.0}));
  }
}

/// The models can tell: without the choice the same controls go elsewhere, or refuse.
TEST_P(EveryRollover, GoesElsewhereWithAbsoluteAnglesBeyondATurn) {
  const Dialect& dialect = *GetParam();
  const Plan plan = rotary_plan(TestCycle::standard, {0, 90, 180, 270, 306.4577}, 4);
  const std::string program = turned_program(dialect, plan, {});
  EXPECT_NE(program.find("ROLLOVER OFF, NOT FOR AN AXIS THAT COUNTS TO 360 DEG ONLY"), std::string::npos);
  ASSERT_NO_FATAL_FAILURE(expect_turned(dialect.id, program, plan, {AxisRule::counts_on, -4.0}));
  for (AxisRule rule : rollover_rules.at(std::string(dialect.id))) {
    bool as_planned = true;
    try {
      const auto trace = testing_support::run_program(dialect.id, program, {rule, 0.0});
      const std::vector<PlannedMove> planned = moves(plan);
      for (std::size_t k = 1; k < planned.size(); ++k) {
        const double way = trace.visits.at(k).position - trace.visits[k - 1].position;
        as_planned = as_planned && std::abs(way - planned[k].to.in_native() + planned[k - 1].to.in_native()) < 1e-6;
      }
    } catch (const std::runtime_error&) {
      as_planned = false;
    }
    EXPECT_FALSE(as_planned) << dialect.id << " rule " << static_cast<int>(rule);
  }
}

/// Within one turn absolute angles are as good as increments, unless their sign tells the way.
TEST_P(EveryRollover, IsNotDoubtedWithoutItWhereTheAxisStaysWithinATurn) {
  const Dialect& dialect = *GetParam();
  for (const auto& targets : {std::vector<double>{10, 45, 80}, {4, 90, 180, 270, 355.9}}) {
    const Plan plan = rotary_plan(TestCycle::pilgrim, targets, 4);
    const std::string program = turned_program(dialect, plan, {});
    const bool tilts = targets.back() < 90;
    // The warm-up goes from end to end, the short way through 0°.
    EXPECT_EQ(program.find("COUNTS TO 360 DEG ONLY") == std::string::npos, tilts);
    EXPECT_EQ(program.find("ROLLOVER OFF, NOT FOR AN AXIS WHOSE") != std::string::npos, tilts);
    for (AxisRule rule : rollover_rules.at(std::string(dialect.id)))
      if (tilts && (rule == AxisRule::shortest || rule == AxisRule::within_turn))
        ASSERT_NO_FATAL_FAILURE(expect_turned(dialect.id, program, plan, {rule, 12.0})) << program;
  }
}

std::vector<const Dialect*> dialects_with_rollover() {
  std::vector<const Dialect*> list;
  for (const Dialect* dialect : dialect_table())
    if (dialect->id != "grbl") list.push_back(dialect);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Nc, EveryRollover, testing::ValuesIn(dialects_with_rollover()), [](const auto& dialect) {
  std::string name(dialect.param->id);
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(Rollover, IsToldInTheProgram) {
  const Plan plan = rotary_plan(TestCycle::standard, {0, 90.5}, 4);
  const std::string fanuc = turned_program(*find_dialect("fanuc"), plan, {.rollover = true});
  for (const char* line :
       {"(ROLLOVER ON, ALL MOVES BUT THE FIRST ARE INCREMENTS)",
        "(THE FIRST MOVE, TO 356.0000 DEG, GOES THE WAY THAT THE CONTROL CHOOSES)", "(DO NOT BEGIN IN THE MIDDLE)",
        "(THE CONTROL MUST KEEP 1 DECIMAL, WHAT IT DROPS WOULD ADD UP)", "N40 G1 C356.0000 F720. (TO THE START)",
        " G91 G1 C4.0000 F720. (TARGET 1 UP)", " G90\nN"})
    EXPECT_NE(fanuc.find(line), std::string::npos) << line << "\n" << fanuc;
  const std::string siemens = turned_program(*find_dialect("siemens-840d"), plan, {.rollover = true});
  for (const char* line :
       {"ROLLOVER ON, ANGLES OF ONE TURN WITH THEIR DIRECTION", "THE FIRST MOVE, TO 356.0000 DEG, GOES THE SHORT WAY",
        " G1 C=DC(356.0000) F720 ", " G1 C=ACP(0.0000) F720 ", " G1 C=ACN(90.5000) F720 "})
    EXPECT_NE(siemens.find(line), std::string::npos) << line << "\n" << siemens;
  const std::string heidenhain = turned_program(*find_dialect("heidenhain"), plan, {.rollover = true});
  for (const char* line : {" M127\r\n", " L C+356.0000 R0 F720", " L IC+4.0000 R0 F720", " L IC-90.5000 R0 F720"})
    EXPECT_NE(heidenhain.find(line), std::string::npos) << line << "\n" << heidenhain;
}

/// Whole degrees need no decimal of the control, and nothing is said of them.
TEST(Rollover, AsksForNoDecimalsThatNoIncrementHas) {
  const Plan plan = rotary_plan(TestCycle::standard, {0, 90}, 4);
  EXPECT_EQ(turned_program(*find_dialect("fanuc"), plan, {.rollover = true}).find("MUST KEEP"), std::string::npos);
}

TEST(Rollover, IsRefusedWhereItMeansNothing) {
  Plan plan = rotary_plan(TestCycle::standard, {0, 90}, 4);
  const auto refused = [&](std::string_view id) {
    const auto program = find_dialect(id)->write({&plan, 1}, {.rollover = true});
    return program ? std::string() : program.error().message;
  };
  EXPECT_EQ(refused("grbl"),
            "found rollover asked for, expected none: the rotary axes of this control count on through 0° and 360°");
  plan.axis = {.name = "X", .kind = AxisKind::linear};
  EXPECT_EQ(refused("fanuc"), "found rollover asked for, expected it of a rotary axis alone");
  PointTour tour{{}, {{{1, 2, 3}}}, 1000.0, Duration::s(1)};
  EXPECT_FALSE(find_dialect("fanuc")->write_tour(tour, {.rollover = true}));
}

TEST(Rollover, IsNotSpokenOfWithLinearAxes) {
  Plan plan = rotary_plan(TestCycle::standard, {0, 90}, 4);
  plan.axis = {.name = "X", .kind = AxisKind::linear};
  for (const Dialect* dialect : dialect_table())
    EXPECT_EQ(turned_program(*dialect, plan, {}).find("ROLLOVER"), std::string::npos) << dialect->id;
}

}  // namespace
}  // namespace axiometry::nc
