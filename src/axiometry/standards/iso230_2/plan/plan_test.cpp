// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/plan/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/standards/iso230_2/programme.h"
#include "axiometry/standards/iso230_6.h"

namespace axiometry::iso230_2 {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Position at(double x) { return Position::native(x); }

PlanRequest request(double from, double to, AxisKind kind = AxisKind::linear) {
  PlanRequest r;
  r.axis.name = "X";
  r.axis.kind = kind;
  r.axis.travel_begin = at(from);
  r.axis.travel_end = at(to);
  r.seed = 7;
  return r;
}

PlanRequest rotary(double from, double to) { return request(from, to, AxisKind::rotary); }

std::string reason(const PlanRequest& r) {
  const auto plan = make_plan(r);
  return plan ? "" : plan.error().message;
}

/// "5.2 note", without the words.
std::vector<std::string> kinds(const Plan& plan) {
  std::vector<std::string> list;
  for (const Finding& f : plan_findings(plan)) list.push_back(f.clause + " " + std::string(severity_name(f.severity)));
  return list;
}

std::vector<std::string> messages(const Plan& plan) {
  std::vector<std::string> list;
  for (const Finding& f : plan_findings(plan)) list.push_back(f.message);
  return list;
}

double last_of(const Plan& plan) { return plan.targets.back().in_native(); }
double first_of(const Plan& plan) { return plan.targets.front().in_native(); }

/// Largest |P_i − (i − 1)·p| over a measurement travel.
double largest_shift(const Plan& plan, double from, double to) {
  double shift = 0.0;
  const double p = (to - from) / static_cast<double>(plan.targets.size() - 1);
  for (std::size_t i = 0; i < plan.targets.size(); ++i)
    shift = std::max(shift, std::abs(plan.targets[i].in_native() - from - static_cast<double>(i) * p));
  return shift;
}

TEST(Plan230, ShortAxisHasFiveTargetsFiveRunsAndRoomForTheOverruns) {
  const Plan plan = make_plan(request(0, 500)).value();
  EXPECT_EQ(plan.clause, "5.3.2");
  EXPECT_EQ(plan.targets.size(), 5u);
  EXPECT_EQ(plan.runs, 5u);
  EXPECT_EQ(plan.cycle, TestCycle::standard);
  EXPECT_EQ(plan.overrun, at(5));
  EXPECT_GE(reach(plan).lowest.in_native(), 0.0);
  EXPECT_LE(reach(plan).highest.in_native(), 500.0);
  EXPECT_EQ(plan.seed, 7u);
  EXPECT_THAT(kinds(plan), IsEmpty());
}

TEST(Plan230, EveryPlanOfItsOwnMakingConformsOnEveryTravel) {
  for (double travel : {12.0, 90.0, 500.0, 1000.0, 1744.0, 1999.0, 2000.0, 2500.0, 4300.0, 12'000.0})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      PlanRequest r = request(-0.25 * travel, 0.75 * travel);
      r.seed = seed;
      const auto plan = make_plan(r);
      ASSERT_TRUE(plan) << plan.error().message;
      EXPECT_TRUE(conforming(plan_findings(*plan))) << travel << " " << messages(*plan).front();
    }
  for (double travel : {20.0, 90.0, 100.0, 180.0, 270.0, 359.0, 360.0, 400.0, 1800.0, 5000.0})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      PlanRequest r = rotary(-0.25 * travel, 0.75 * travel);
      r.seed = seed;
      const auto plan = make_plan(r);
      ASSERT_TRUE(plan) << plan.error().message;
      EXPECT_TRUE(conforming(plan_findings(*plan))) << travel << " " << messages(*plan).front();
    }
}

TEST(Plan230, IsInAccordanceOnlyWhereItsTestWouldBe) {
  EXPECT_TRUE(in_accordance(plan_findings(make_plan(request(0, 500)).value())));
  PlanRequest even = request(0, 500);
  even.targets = {at(20), at(130), at(240), at(350), at(460)};
  const auto findings = plan_findings(make_plan(even).value());
  EXPECT_TRUE(conforming(findings));
  EXPECT_FALSE(in_accordance(findings));
  EXPECT_THAT(kinds(make_plan(even).value()), Contains("5.2 missing"));
}

TEST(Plan230, StatesAStandardAndAClauseThatAPlanMayHave) {
  EXPECT_THAT(plan_standards, ::testing::ElementsAre(edition, iso230_6::edition));
  for (const PlanRequest& r : {request(0, 500), request(0, 6000), rotary(0, 360), rotary(0, 1800)})
    EXPECT_THAT(plan_clauses, Contains(make_plan(r)->clause));
}

TEST(Plan230, TargetsFollowTheFormula) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    PlanRequest r = request(0, 1000);
    r.seed = seed;
    r.count = 11;
    r.measurement = Stretch{at(10), at(990)};
    const Plan without = make_plan(r).value();
    EXPECT_LE(largest_shift(without, 10, 990), 0.3 * 98 + 5e-4);
    EXPECT_GE(largest_shift(without, 10, 990), 10.0);
    r.axis.expected_period = at(10);
    const Plan with = make_plan(r).value();
    EXPECT_LE(largest_shift(with, 10, 990), 10.0 + 5e-4);
    EXPECT_GE(first_of(with), 10.0);
    EXPECT_LE(last_of(with), 990.0);
    EXPECT_TRUE(std::ranges::is_sorted(with.targets, std::ranges::less{}));
  }
}

TEST(Plan230, TheRandomPartIsUniform) {
  std::vector<double> shifts;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    PlanRequest r = request(0, 1100);
    r.seed = seed;
    r.count = 11;
    r.measurement = Stretch{at(50), at(1050)};
    r.axis.expected_period = at(10);
    const Plan plan = make_plan(r).value();
    for (std::size_t i = 1; i + 1 < 11; ++i)
      shifts.push_back(plan.targets[i].in_native() - 50.0 - 100.0 * static_cast<double>(i));
  }
  std::ranges::sort(shifts);
  double distance = 0.0;  // Kolmogorov–Smirnov; 1.95/√n is exceeded by chance once in a thousand
  for (std::size_t k = 0; k < shifts.size(); ++k)
    distance = std::max(distance, std::abs((shifts[k] + 10.0) / 20.0 -
                                           (static_cast<double>(k) + 0.5) / static_cast<double>(shifts.size())));
  EXPECT_LT(distance, 1.95 / std::sqrt(static_cast<double>(shifts.size())));
}

TEST(Plan230, ASeedGivesTheSameTargetsEverywhere) {
  // Regression: what this program gave first. A seed in an old plan must go on giving its targets.
  PlanRequest r = request(0, 500);
  r.axis.expected_period = at(10);
  const Plan plan = make_plan(r).value();
  EXPECT_EQ(plan.targets, make_plan(r)->targets);
  r.seed = 8;
  EXPECT_NE(plan.targets, make_plan(r)->targets);
  std::vector<double> targets;
  for (Position p : plan.targets) targets.push_back(p.in_native());
  EXPECT_EQ(targets, (std::vector<double>{10.712, 126.213, 256.308, 365.724, 487.808}));
}

TEST(Plan230, TargetsAreRoundedToTheStep) {
  PlanRequest r = request(0, 500);
  r.step = at(0.25);
  const Plan quarters = make_plan(r).value();
  for (Position p : quarters.targets) EXPECT_EQ(p.in_native() * 4.0, std::round(p.in_native() * 4.0));
  r.step = at(0.001);
  const Plan fine = make_plan(r).value();
  for (Position p : fine.targets) EXPECT_EQ(p.in_native(), std::round(p.in_native() * 1000.0) / 1000.0);
}

TEST(Plan230, TargetsKeepOffTheSamplingPointsOfTheCompensation) {
  PlanRequest r = request(0, 500);
  r.step = at(1);
  for (int k = 0; k <= 500; ++k)
    if (k % 7 != 3) r.axis.compensation_points.push_back(k);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    r.seed = seed;
    const Plan plan = make_plan(r).value();
    for (Position p : plan.targets) EXPECT_EQ(static_cast<int>(p.in_native()) % 7, 3);
  }
  r.axis.compensation_points.clear();
  for (int k = 0; k <= 500; ++k) r.axis.compensation_points.push_back(k);
  EXPECT_THAT(messages(make_plan(r).value()),
              Contains(HasSubstr("found 5 of 5 targets on sampling points of the compensation")));
}

TEST(Plan230, LongAxisIsTestedWholeAndOverTwoMetres) {
  const Plan plan = make_plan(request(0, 6000)).value();
  EXPECT_EQ(plan.clause, "5.3.3");
  EXPECT_EQ(plan.runs, 1u);
  EXPECT_EQ(plan.targets.size(), 25u);  // 5 980/250 → 24 intervals
  ASSERT_EQ(plan.further.size(), 1u);
  const Plan& area = plan.further[0];
  EXPECT_EQ(area.clause, "5.3.2");
  EXPECT_EQ(area.title, "Normal working area, 2000 to 4000 mm");
  EXPECT_EQ(area.runs, 5u);
  EXPECT_EQ(area.targets.size(), 10u);
  EXPECT_GE(first_of(area), 2000.0);
  EXPECT_LE(last_of(area), 4000.0);
  EXPECT_THAT(kinds(plan), IsEmpty());
}

TEST(Plan230, StretchesOfTheNormalWorkingAreaAreTheUsersChoice) {
  PlanRequest r = request(0, 6000);
  r.areas = {{at(100), at(2100)}, {at(3000), at(5000)}};
  const Plan plan = make_plan(r).value();
  ASSERT_EQ(plan.further.size(), 2u);
  EXPECT_NE(first_of(plan.further[0]) - 100.0, first_of(plan.further[1]) - 3000.0);
  EXPECT_GE(first_of(plan.further[1]), 3000.0);
  r.areas = {{at(100), at(2200)}};
  EXPECT_THAT(reason(r), HasSubstr("found a stretch of 2100 mm"));
  r.areas = {{at(4500), at(6500)}};
  EXPECT_THAT(reason(r), HasSubstr("expected room within 0 to 6000 mm"));
  r = request(0, 500);
  r.areas = {{at(100), at(200)}};
  EXPECT_THAT(reason(r), HasSubstr("found a normal working area for a test over"));
}

TEST(Plan230, EverySegmentOfAScaleHasATarget) {
  for (double segment : {90.0, 170.0, 333.0, 1000.0})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const double travel = seed % 2 ? 3000.0 : 1600.0;
      PlanRequest r = request(0, travel);
      r.seed = seed;
      r.segment = at(segment);
      const Plan plan = make_plan(r).value();
      for (double from = 0.0; from < travel - 10.0 - 1e-9; from += segment)
        EXPECT_TRUE(std::ranges::any_of(
            plan.targets, [&](Position p) { return p.in_native() >= from && p.in_native() <= from + segment; }))
            << segment << " from " << from;
    }
}

TEST(Plan230, WhatWouldHaveNoEffectIsRefused) {
  PlanRequest r = request(0, 500);
  r.segment = at(1000);
  EXPECT_EQ(reason(r),
            "found segments of 1000 mm, of which one holds the measurement travel 5 to 495 mm, expected shorter ones");
  r.segment = at(495);
  EXPECT_NE(reason(r), "");
  r.segment = at(494);
  EXPECT_EQ(reason(r), "");
  r.targets = {at(100), at(300)};
  EXPECT_EQ(reason(r), "found segments of a scale beside positions of targets, expected them where targets are drawn");
  r.segment.reset();
  EXPECT_EQ(reason(r), "");
  r.step = at(0.01);
  EXPECT_THAT(reason(r), HasSubstr("found a step of targets beside their positions"));
  r = request(0, 500);
  r.axis.expected_period = at(10);
  r.periodic.emplace();
  r.segment = at(5);
  EXPECT_THAT(reason(r), HasSubstr("in the test for a periodic error"));
  r = rotary(0, 360);
  r.segment = at(20);
  EXPECT_EQ(reason(r),
            "found segments of a scale of an axis that turns without end, expected an axis with soft limits");
  r = request(0, 500);
  r.cycle = TestCycle::user_defined;
  r.sequence = {{0, Direction::up, 0}, {4, Direction::down, 0}};
  r.runs = 4;
  EXPECT_EQ(reason(r), "found 4 as number of runs beside a sequence of 1, expected the sequence alone, which says it");
  r.runs = 1;
  EXPECT_EQ(reason(r), "");
}

TEST(Plan230, RotaryAxisFollowsTable1) {
  EXPECT_EQ(make_plan(rotary(0, 90))->targets.size(), 3u);
  EXPECT_EQ(make_plan(rotary(0, 180))->targets.size(), 5u);
  EXPECT_EQ(make_plan(rotary(0, 200))->targets.size(), 8u);
  EXPECT_EQ(make_plan(rotary(0, 90))->clause, "5.3.4");
  EXPECT_EQ(make_plan(rotary(0, 90))->runs, 5u);
}

TEST(Plan230, DenseTargetsStayInOrderBesideAPrincipalPositionThatIsASamplingPoint) {
  PlanRequest r = rotary(0, 360);
  r.axis.compensation_points = {0, 90, 180, 270, 360};
  for (std::size_t count : {720u, 3600u, 7200u})
    for (r.seed = 0; r.seed < 20; ++r.seed) {
      r.count = count;
      EXPECT_EQ(reason(r), "") << count;
    }
}

TEST(Plan230, TheFeedIsReachedAtTheAccelerationOfTheAxis) {
  PlanRequest r = request(0, 500);
  r.feed = 20'000;
  r.acceleration = 10'000;
  Plan plan = make_plan(r).value();
  const auto unreached = [](const std::vector<Finding>& findings) {
    return std::ranges::count_if(findings, [](const Finding& f) { return f.message.contains("to reach the feed"); });
  };
  EXPECT_EQ(unreached(plan_findings(plan)), 0);
  plan.acceleration = std::nullopt;
  EXPECT_EQ(unreached(plan_findings(plan)), 1);
}

TEST(Plan230, TurningAxisIsMeasuredAtItsPrincipalPositions) {
  const Plan plan = make_plan(rotary(0, 360)).value();
  EXPECT_EQ(plan.targets.size(), 8u);
  for (double principal : {0.0, 90.0, 180.0, 270.0}) EXPECT_THAT(plan.targets, Contains(at(principal)));
  EXPECT_FALSE(plan.axis.travel_begin);
  EXPECT_THAT(kinds(plan), ::testing::ElementsAre("3.1 note", "5.3.4 note"));
  const Plan limited = make_plan(rotary(-10, 280)).value();
  for (double principal : {0.0, 90.0, 180.0, 270.0}) EXPECT_THAT(limited.targets, Contains(at(principal)));
  PlanRequest compensated = rotary(0, 360);
  compensated.axis.compensation_points = {0, 90, 180, 270};
  EXPECT_THAT(kinds(make_plan(compensated).value()), ::testing::ElementsAre("3.1 note", "5.3.4 note"));
  EXPECT_THAT(make_plan(compensated)->targets, Not(Contains(at(90))));
}

TEST(Plan230, ManyTurnsHaveEightTargetsInEach) {
  const Plan plan = make_plan(rotary(0, 1800)).value();
  EXPECT_EQ(plan.clause, "5.3.5");
  EXPECT_EQ(plan.runs, 1u);
  EXPECT_GE(plan.targets.size(), 40u);
  ASSERT_EQ(plan.further.size(), 1u);
  EXPECT_EQ(plan.further[0].clause, "5.3.4");
  EXPECT_EQ(plan.further[0].runs, 5u);
  const Plan long_one = make_plan(rotary(0, 7200)).value();
  EXPECT_LE(last_of(long_one) - first_of(long_one), 1800.0);
  EXPECT_THAT(kinds(long_one), ::testing::ElementsAre("5.3.5 note"));
}

TEST(Plan230, OtherCyclesSayWhatTheyAre) {
  PlanRequest r = request(0, 500);
  r.cycle = TestCycle::step;
  EXPECT_EQ(make_plan(r)->clause, "Annex B");
  EXPECT_THAT(kinds(make_plan(r).value()), Contains("Annex B departure"));
  r.cycle = TestCycle::pilgrim;
  EXPECT_EQ(make_plan(r)->clause, "");
  EXPECT_FALSE(conforming(plan_findings(make_plan(r).value())));
  r.cycle = TestCycle::unidirectional;
  EXPECT_THAT(messages(make_plan(r).value()), Contains(HasSubstr("found approaches from one direction only (↑)")));
  r.cycle = TestCycle::user_defined;
  EXPECT_THAT(reason(r), HasSubstr("found a user-defined cycle without a sequence"));
  r.sequence = {{0, Direction::up, 0}, {4, Direction::down, 1}};
  EXPECT_EQ(make_plan(r)->runs, 2u);
  r.sequence = {{5, Direction::up, 0}};
  EXPECT_THAT(reason(r), HasSubstr("found an approach to target 6, expected 1 to 5"));
}

TEST(Plan230, PeriodicErrorGetsDenseTargetsOverItsPeriods) {
  PlanRequest r = request(0, 500);
  r.periodic = PeriodicTest{at(200)};
  EXPECT_THAT(reason(r), HasSubstr("found no period"));
  r.axis.expected_period = at(10);
  const Plan plan = make_plan(r).value();
  EXPECT_EQ(plan.clause, "Annex C");
  EXPECT_EQ(plan.cycle, TestCycle::unidirectional);
  EXPECT_EQ(plan.targets.size(), 25u);
  EXPECT_EQ(plan.runs, 1u);
  EXPECT_EQ(first_of(plan), 185.0);
  EXPECT_EQ(last_of(plan), 215.0);
  for (std::size_t i = 0; i < 25; ++i)
    EXPECT_NEAR(plan.targets[i].in_native(), 185.0 + 1.25 * static_cast<double>(i), 0.3 * 1.25 + 5e-4);
  EXPECT_THAT(kinds(plan), IsEmpty());
  r.interval = at(4);
  EXPECT_THAT(kinds(make_plan(r).value()), Contains("Annex C departure"));
  r.interval.reset();
  r.axis.expected_period = at(300);
  EXPECT_THAT(reason(r), HasSubstr("expected two periods of 300 mm at least"));
}

TEST(Plan230, SaysWhereThePeriodIsTooLongForTheInterval) {
  PlanRequest r = request(0, 500);
  for (double period : {40.0, 70.0, 110.0, 122.5, 245.0}) {
    r.axis.expected_period = at(period);
    const Plan plan = make_plan(r).value();
    EXPECT_THAT(messages(plan), Contains(HasSubstr("beside a mean interval of"))) << period;
    EXPECT_TRUE(conforming(plan_findings(plan)));
    EXPECT_LE(largest_shift(plan, 5, 495), 0.3 * 122.5 + 5e-4);
  }
  r.axis.expected_period = at(10);
  EXPECT_THAT(messages(make_plan(r).value()), IsEmpty());
}

TEST(Plan230, SaysWhereTargetsSampleOnePhaseOfThePeriodOnly) {
  PlanRequest r = request(0, 500);
  r.axis.expected_period = at(20);
  for (double x : {20.0, 141.0, 260.0, 378.0, 480.0}) r.targets.push_back(at(x));
  const Plan plan = make_plan(r).value();
  EXPECT_FALSE(plan.seed);
  EXPECT_THAT(messages(plan), Contains(HasSubstr("found targets in 15 % only of the period of 20 mm")));
}

TEST(Plan230, SaysWhereARotaryAxisGoesBeyondOneTurn) {
  const auto beyond = Contains(HasSubstr("beyond one turn from 0°"));
  EXPECT_THAT(messages(make_plan(rotary(0, 360)).value()), beyond);
  EXPECT_THAT(messages(make_plan(rotary(-10, 280)).value()), beyond);
  EXPECT_THAT(messages(make_plan(rotary(0, 1800)).value()), beyond);
  EXPECT_THAT(messages(make_plan(rotary(0, 359)).value()), Not(beyond));
  EXPECT_THAT(messages(make_plan(request(-100, 500)).value()), Not(beyond));
}

TEST(Plan230, FindsWhatPeopleEditedAwayFromTheStandard) {
  Plan plan = make_plan(request(0, 500)).value();
  plan.targets.erase(plan.targets.begin() + 2);
  EXPECT_THAT(messages(plan), Contains(HasSubstr("found 4 targets over")));
  plan = make_plan(request(0, 500)).value();
  plan.runs = 3;
  EXPECT_THAT(messages(plan), Contains(HasSubstr("found 3 approaches in each direction")));
  plan = make_plan(request(0, 500)).value();
  plan.targets.back() = at(498);
  EXPECT_THAT(messages(plan),
              Contains("found the overrun at 503 mm above the axis travel to 500 mm, expected ends that "
                       "can be approached from both sides"));
  plan = make_plan(request(0, 500)).value();
  plan.targets = {at(100)};
  EXPECT_THAT(kinds(plan), Contains("5.3.2 departure"));
  plan = make_plan(request(0, 500)).value();
  plan.warm_up_runs = 0;
  plan.dwell = Duration::s(0);
  EXPECT_THAT(kinds(plan), ::testing::ElementsAre("4.3 missing", "5.1 missing"));
  EXPECT_TRUE(conforming(plan_findings(plan)));
  EXPECT_FALSE(in_accordance(plan_findings(plan)));
  plan = make_plan(request(0, 6000)).value();
  plan.further.clear();
  EXPECT_THAT(kinds(plan), Contains("5.3.3 missing"));
  plan = make_plan(request(0, 6000)).value();
  plan.further[0].runs = 4;
  EXPECT_THAT(messages(plan), Contains(HasSubstr("Normal working area, 2000 to 4000 mm: found 4 approaches")));
}

TEST(Plan230, FindsRestsAndOverrunsInWhichNothingCanBeRead) {
  Plan plan = make_plan(request(0, 500)).value();
  plan.dwell = Duration::s(0.001);
  plan.overrun = at(0.002);
  EXPECT_THAT(kinds(plan), ::testing::IsSupersetOf({"5.1 missing", "3.2 missing"}));
  EXPECT_THAT(messages(plan), Contains("found a dwell of 0.001 s at the targets, expected a rest long enough to reach "
                                       "and record each: 0.1 s at least"));
  EXPECT_THAT(messages(plan),
              Contains("found overruns of 0.002 mm, expected more than an axis loses on reversal: 0.1 mm at least"));
}

TEST(Plan230, SaysWhichTargetsNothingApproaches) {
  Plan plan = make_plan(request(0, 500)).value();
  plan.cycle = TestCycle::user_defined;
  plan.runs = 1;
  plan.sequence = {{1, Direction::up, 0}, {3, Direction::down, 0}, {4, Direction::up, 0}};
  EXPECT_THAT(messages(plan), Contains("found no approach to targets 1, 3, expected some to each target"));
  plan.sequence.push_back({0, Direction::down, 0});
  EXPECT_THAT(messages(plan), Contains("found no approach to target 3, expected some to each target"));
}

TEST(Plan230, OverrunsReachTheFeedOrSayThatTheyDoNot) {
  PlanRequest r = request(0, 500);
  r.feed = 6000;  // 100 mm/s: 10 mm at 1 000 mm/s²
  EXPECT_EQ(make_plan(r)->overrun, at(10));
  EXPECT_THAT(kinds(make_plan(r).value()), IsEmpty());
  r.feed = 30'000;  // 500 mm/s: 250 mm, more than 10 % of the travel
  EXPECT_EQ(make_plan(r)->overrun, at(50));
  EXPECT_THAT(messages(make_plan(r).value()),
              Contains("found overruns of 50 mm, expected 250 mm to reach the feed of 30000 mm/min at 1000 mm/s²"));
  EXPECT_EQ(make_plan(request(0, 60))->overrun, at(1));
  EXPECT_EQ(make_plan(request(0, 6000))->overrun, at(10));
  r = request(0, 500);
  r.measurement = Stretch{at(2), at(490)};
  EXPECT_EQ(make_plan(r)->overrun, at(2));
}

TEST(Plan230, DurationIsWhatAHandCalculationGives) {
  Plan plan;
  plan.targets = {at(0), at(100)};
  plan.runs = 1;
  plan.overrun = at(10);
  plan.feed = 6000;  // 100 mm/s; at 1 000 mm/s² reached and left within 10 mm in 0.2 s
  plan.dwell = Duration::s(2);
  // −10 → 0 → 100 → 110 → 100 → 0 → −10: four ways of 10 mm at 0.2 s, two of 100 mm at 1.1 s, four dwells.
  EXPECT_NEAR(estimated_duration(plan).in_s(), 4 * 0.2 + 2 * 1.1 + 4 * 2.0, 1e-12);
  // At 250 mm/s² it takes 40 mm: 10 mm are 2·√(10/250) = 0.4 s, 100 mm are 1 + 0.4 s.
  plan.acceleration = 250;
  EXPECT_NEAR(estimated_duration(plan).in_s(), 4 * 0.4 + 2 * 1.4 + 4 * 2.0, 1e-12);
  plan.acceleration = std::nullopt;
  plan.warm_up_runs = 1;  // −10 → 110 → −10: 120 mm at 1.2 + 0.1 s, twice
  EXPECT_NEAR(estimated_duration(plan).in_s(), 2 * 1.3 + 4 * 0.2 + 2 * 1.1 + 4 * 2.0, 1e-12);
}

TEST(Plan230, DurationHasTheWaysToAndFromALine) {
  Plan plan;
  plan.targets = {at(0), at(100)};
  plan.runs = 1;
  plan.overrun = at(10);
  plan.feed = 6000;
  set_spatial_line(plan.axis, {{0, 0, 0}, {0, 1, 0}});
  const double line = estimated_duration(plan).in_s();
  plan.way_in_mm = {{-30, -10, 40}, {0, -10, 40}};  // 30 mm and 40 mm to (0, −10, 0): 0.3 and 0.4 s, 0.1 s more each
  EXPECT_NEAR(estimated_duration(plan).in_s(), line + 0.4 + 0.5, 1e-12);
  plan.way_out_mm = {{0, -10, 60}};
  EXPECT_NEAR(estimated_duration(plan).in_s(), line + 0.4 + 0.5 + 0.7, 1e-12);
}

TEST(Plan230, TellsADiagonalFromATestOfOneAxis) {
  Plan plan = make_plan(request(0, 500)).value();
  set_spatial_line(plan.axis, {{0, 0, 0}, {1, 0, 0}});
  EXPECT_THAT(kinds(plan), IsEmpty());
  plan.axis.line_direction = {3, 4, 0};
  EXPECT_THAT(messages(plan), Contains("found a line that 2 axes drive together (direction 3 4 0): a diagonal "
                                       "displacement test, whose programme is judged along the line as that of one "
                                       "axis"));
  EXPECT_THAT(kinds(plan), ::testing::ElementsAre("230-6 note"));
}

TEST(Plan230, RefusesWhatCannotBePlannedWithTheNumbers) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reason(request(500, 0)),
            "found the axis travel 500 to 0 mm, expected its lower end and then its higher one, within ±1000000 mm");
  EXPECT_THAT(reason(request(0, 0)), HasSubstr("found the axis travel 0 to 0 mm"));
  EXPECT_NE(reason(request(0, nan)), "");
  EXPECT_NE(reason(request(0, 1e9)), "");
  EXPECT_EQ(reason(request(0, 2)),
            "found overruns of 1 mm at both ends of a travel of 2 mm, expected room for targets between");
  EXPECT_THAT(reason(request(0, 2.01)), HasSubstr("found room for 5 targets every"));
  PlanRequest r = request(0, 500);
  r.measurement = Stretch{at(0), at(500)};
  EXPECT_EQ(reason(r),
            "found the measurement travel 0 to 500 mm that with overruns of 5 mm reaches from -5 to 505 mm, expected "
            "room within 0 to 500 mm");
  r = request(0, 500);
  r.soft_limits = Stretch{at(10), at(480)};
  EXPECT_EQ(reason(r), "");
  r.measurement = Stretch{at(12), at(470)};
  r.overrun = at(5);
  EXPECT_THAT(reason(r), HasSubstr("reaches from 7 to 475 mm, expected room within 10 to 480 mm"));
  r = request(0, 500);
  r.targets = {at(100), at(600)};
  EXPECT_THAT(reason(r), HasSubstr("found the targets from 100 to 600 mm"));
  r.targets = {at(100), at(300)};
  r.measurement = Stretch{at(150), at(400)};
  EXPECT_EQ(reason(r), "found targets from 100 to 300 mm, expected them within the measurement travel 150 to 400 mm");
  r.measurement.reset();
  r.targets = {at(100), at(100)};
  EXPECT_THAT(reason(r), HasSubstr("expected ascending targets"));
  r.targets = {at(nan), at(100)};
  EXPECT_NE(reason(r), "");
  r = request(0, 500);
  r.count = 1'000'000'000;
  EXPECT_EQ(reason(r), "found 1000000000 targets, expected 2 to 10000");
  r.count.reset();
  r.interval = at(1e-6);
  EXPECT_EQ(reason(r), "found 4.9e+08 targets over 490 mm, expected at most 10000");
  r.interval.reset();
  r.segment = at(1e-9);
  EXPECT_THAT(reason(r), HasSubstr("expected at most 10000"));
  r.segment.reset();
  r.count = 9000;
  r.runs = 10'000;
  EXPECT_THAT(reason(r), HasSubstr("approaches, expected at most 1000000"));
  for (double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    r = request(0, 500);
    r.feed = bad;
    EXPECT_THAT(reason(r), HasSubstr("found the feed"));
    r = request(0, 500);
    r.overrun = at(bad);
    EXPECT_THAT(reason(r), HasSubstr("found the overrun"));
    r = request(0, 500);
    r.axis.expected_period = at(bad);
    EXPECT_THAT(reason(r), HasSubstr("found the expected period"));
    r = request(0, 500);
    r.interval = at(bad);
    EXPECT_THAT(reason(r), HasSubstr("found the interval"));
  }
  r = request(0, 500);
  r.runs = 0;
  EXPECT_NE(reason(r), "");
  r = request(0, 500);
  r.overrun = at(300);
  EXPECT_THAT(reason(r), HasSubstr("found overruns of 300 mm at both ends of a travel of 500 mm"));
  r = request(0, 500);
  r.axis.travel_end.reset();
  EXPECT_THAT(reason(r), HasSubstr("found no axis travel"));
}

TEST(Plan230, OtherErrorsThanPositionsAreNoBusinessOfTheStandard) {
  PlanRequest r = request(0, 3000);
  r.errors = {{'Y', 'X'}, {'B', 'X'}};
  r.runs = 5;
  Plan plan = make_plan(r).value();
  EXPECT_EQ(plan.errors, r.errors);
  EXPECT_EQ(plan.clause, "");
  EXPECT_TRUE(plan.further.empty()) << "a long axis has further tests of its positions only";
  plan.targets.resize(3);  // a test of positions over more than 2 000 mm would have to have more
  plan.runs = 2;
  EXPECT_TRUE(conforming(plan_findings(plan)));
  EXPECT_THAT(messages(plan), Contains(HasSubstr("found a plan made for EYX, EBX, of which ISO 230-2 says nothing")));
  plan.axis.travel_end = at(100);  // but where the axis cannot go it cannot go
  EXPECT_FALSE(conforming(plan_findings(plan)));
  r.areas = {{at(500), at(2500)}};
  EXPECT_EQ(reason(r), "found a normal working area for a plan made for EYX, EBX, expected one for positions only");
}

TEST(Plan230, SaysBeforeTheMeasurementWhatNobodyCanEvaluate) {
  PlanRequest r = request(0, 3000);
  r.errors = {{'B', 'X'}};
  Plan plan = make_plan(r).value();
  plan.targets.resize(2);
  EXPECT_THAT(messages(plan), Not(Contains(HasSubstr("expected at least"))));
  plan.targets.resize(1);
  EXPECT_THAT(messages(plan), Contains(HasSubstr("found 1 target for EBX, expected at least 2")));
  plan = make_plan(r).value();
  plan.targets.resize(2);
  plan.errors = {{'Y', 'X'}};
  EXPECT_THAT(messages(plan), Contains(HasSubstr("found 2 targets for EYX, expected at least 3")));
  r.errors = {{'X', 'X'}, {'Y', 'X'}};
  const Plan with_further = make_plan(r).value();
  ASSERT_FALSE(with_further.further.empty());
  EXPECT_THAT(messages(with_further), Contains(HasSubstr("found further tests in a plan for EXX, EYX")));
}

TEST(Plan230, PositionsAmongOtherErrorsAreJudgedAsEver) {
  PlanRequest r = request(0, 500);
  const Plan positions = make_plan(r).value();
  r.errors = {{'Y', 'X'}, {'X', 'X'}};
  Plan plan = make_plan(r).value();
  EXPECT_EQ(plan.clause, positions.clause);
  EXPECT_EQ(plan.targets, positions.targets);
  EXPECT_EQ(kinds(plan), kinds(positions));
  plan.runs = 2;
  EXPECT_FALSE(conforming(plan_findings(plan)));
  r.errors = {{'X', 'Y'}};
  EXPECT_THAT(reason(r), HasSubstr("found the error EXY in a plan of the axis \"X\""));
}

}  // namespace
}  // namespace axiometry::iso230_2
