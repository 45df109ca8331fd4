// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/test_course.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry {
namespace {

using testing::HasSubstr;
using Measured = axiometry::Test;  // within a TEST, Test is the fixture

using testing_support::none;
const std::vector<testing_support::RunDeviations> two_runs = {{0, 0, 0}, {0, none, 0}};

Measured made(std::optional<TestCycle> cycle, bool up, bool down) {
  const std::vector<testing_support::RunDeviations> no_runs;
  Measured test{{}, testing_support::make_series({1, 2, 3}, up ? two_runs : no_runs, down ? two_runs : no_runs), {}};
  test.metadata.conditions.cycle = cycle;
  return test;
}

/// The number of the reading in its order, from 0.
double place(const Measured& test, std::size_t target, Direction direction, std::size_t run) {
  const TestCourse course = course_of(test);
  return course.at(test.series, target, direction, run) * static_cast<double>(course.steps);
}

TEST(TestCourse, FollowsTheOrderOfEachCycle) {
  const Measured standard = made(TestCycle::standard, true, true);
  EXPECT_DOUBLE_EQ(place(standard, 2, Direction::up, 0), 2);
  EXPECT_DOUBLE_EQ(place(standard, 2, Direction::down, 0), 3);
  EXPECT_DOUBLE_EQ(place(standard, 0, Direction::up, 1), 6) << "a missing reading keeps its time";
  EXPECT_DOUBLE_EQ(place(standard, 0, Direction::down, 1), 11);
  const Measured step = made(TestCycle::step, true, true);
  EXPECT_DOUBLE_EQ(place(step, 0, Direction::down, 1), 3);
  EXPECT_DOUBLE_EQ(place(step, 1, Direction::up, 0), 4);
  const Measured pilgrim = made(TestCycle::pilgrim, true, true);
  EXPECT_DOUBLE_EQ(place(pilgrim, 1, Direction::up, 0), 2);
  EXPECT_DOUBLE_EQ(place(pilgrim, 2, Direction::down, 0), 6);
  EXPECT_DOUBLE_EQ(place(pilgrim, 0, Direction::down, 1), 11);
}

TEST(TestCourse, TakesTheStandardCycleWhereNoneIsStatedAndSaysSo) {
  const Measured unstated = made({}, true, true);
  EXPECT_DOUBLE_EQ(place(unstated, 2, Direction::down, 0), 3);
  EXPECT_EQ(course_of(unstated).basis,
            "readings equally far apart in the order of the standard cycle, none being stated");
  EXPECT_TRUE(course_of(unstated).order_known);
  EXPECT_EQ(course_of(made({}, true, false)).basis, "readings equally far apart in the order of the runs");
}

TEST(TestCourse, LeavesOutADirectionWithoutReadings) {
  EXPECT_DOUBLE_EQ(place(made(TestCycle::standard, true, false), 0, Direction::up, 1), 3);
  EXPECT_DOUBLE_EQ(place(made(TestCycle::unidirectional, true, false), 0, Direction::up, 1), 3);
  const Measured down = made(TestCycle::unidirectional, false, true);
  EXPECT_DOUBLE_EQ(place(down, 2, Direction::down, 0), 0) << "from the last target to the first";
  EXPECT_DOUBLE_EQ(place(down, 0, Direction::down, 1), 5);
  EXPECT_EQ(course_of(down).basis, "readings equally far apart in the order of the unidirectional cycle");
  for (const bool up : {true, false})
    EXPECT_EQ(course_of(made(TestCycle::standard, up, !up)).basis,
              "readings equally far apart in the order of the runs");
  EXPECT_EQ(course_of(made(TestCycle::user_defined, true, false)).basis,
            "readings equally far apart in the order of the runs, their own not being known");
}

TEST(TestCourse, SaysWhereTheOrderIsKnownToNobody) {
  for (const TestCycle cycle : {TestCycle::user_defined, TestCycle::unidirectional}) {
    const TestCourse course = course_of(made(cycle, true, true));
    EXPECT_FALSE(course.order_known);
    EXPECT_THAT(course.basis, HasSubstr("in the order of the standard cycle, their own not being known"));
  }
  for (const TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim})
    EXPECT_TRUE(course_of(made(cycle, true, true)).order_known);
  EXPECT_TRUE(course_of(made(TestCycle::unidirectional, true, false)).order_known);
  Measured timed = made(TestCycle::user_defined, true, false);
  timed.times_s = {100, 190, 110, none, 120, 300, none, none, none, none, none, none};
  EXPECT_TRUE(course_of(timed).order_known);
}

TEST(TestCourse, TakesTheTimesOfTheReadings) {
  Measured test = made(TestCycle::standard, true, false);
  test.times_s = {100, 190, 110, none, 120, 300, none, none, none, none, none, none};
  const TestCourse course = course_of(test);
  EXPECT_DOUBLE_EQ(course.at(test.series, 0, Direction::up, 0), 0.0);
  EXPECT_DOUBLE_EQ(course.at(test.series, 0, Direction::up, 1), 0.45);
  EXPECT_DOUBLE_EQ(course.at(test.series, 2, Direction::up, 1), 1.0);
  EXPECT_EQ(course.duration->in_s(), 200.0);
  EXPECT_EQ(course.steps, 4u);
  EXPECT_EQ(course.basis, "the times of the readings");
}

TEST(TestCourse, DoesWithoutTimesWhereOneIsUnknownOrAllAreTheSame) {
  Measured test = made(TestCycle::standard, true, false);
  test.times_s = {100, none, 110, none, 120, 300, none, none, none, none, none, none};
  EXPECT_FALSE(course_of(test).duration);
  test.times_s.assign(12, 7.0);
  EXPECT_FALSE(course_of(test).duration);
}

}  // namespace
}  // namespace axiometry
