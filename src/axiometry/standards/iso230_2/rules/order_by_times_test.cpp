// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/order_by_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "axiometry/model/plan.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Three targets, two runs in both directions, read `apart` seconds apart in the order of a cycle.
axiometry::Test read_in_order_of(TestCycle order, double apart = 10.0) {
  const std::vector<testing_support::RunDeviations> runs{{0, 1, 2}, {0.1, 1.2, 2.1}};
  axiometry::Test test{{}, testing_support::make_series({0, 100, 200}, runs, runs), {}};
  Plan plan;
  plan.cycle = order;
  plan.runs = 2;
  plan.targets.assign(test.series.targets().begin(), test.series.targets().end());
  test.times_s.assign(12, std::numeric_limits<double>::quiet_NaN());
  double time = 1e9;
  for (const Approach& a : approaches(plan))
    test.times_s[(static_cast<std::size_t>(a.direction) * 3 + a.target) * 2 + a.run] = time += apart;
  return test;
}

std::vector<std::string> told_of(const axiometry::Test& test) {
  std::vector<std::string> messages;
  for (const Finding& finding : order_findings(test)) {
    EXPECT_EQ(finding.severity, Severity::departure);
    messages.push_back(finding.message);
  }
  return messages;
}

TEST(OrderByTimes, IsThatOfTheCycleOrNamesTheOtherOne) {
  for (const TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim}) {
    axiometry::Test test = read_in_order_of(cycle);
    test.metadata.conditions.cycle = cycle;
    EXPECT_THAT(told_of(test), IsEmpty());
  }
  EXPECT_THAT(told_of(read_in_order_of(TestCycle::step)),
              ElementsAre("the times of the readings tell the step cycle, expected that of the standard cycle"));
  axiometry::Test own = read_in_order_of(TestCycle::step);
  own.metadata.conditions.cycle = TestCycle::user_defined;
  EXPECT_THAT(told_of(own), IsEmpty());
}

TEST(OrderByTimes, NamesTheReadingsThatNoCycleHasSo) {
  axiometry::Test test = read_in_order_of(TestCycle::standard);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 2; ++j) std::swap(test.times_s[i * 2 + j], test.times_s[6 + i * 2 + j]);
  EXPECT_THAT(told_of(test),
              ElementsAre("the times of the readings tell another order than that of the standard cycle: "
                          "target 2 ↑ run 1 was read before target 1 ↑ run 1"));
}

TEST(OrderByTimes, SaysNothingOfTimesThatTellNone) {
  axiometry::Test test = read_in_order_of(TestCycle::step);
  test.times_s.assign(12, 0.0);
  EXPECT_THAT(told_of(test), IsEmpty());
  test.times_s.clear();
  EXPECT_THAT(told_of(test), IsEmpty());
  test = read_in_order_of(TestCycle::standard);
  test.times_s[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(told_of(test), IsEmpty());
}

TEST(OrderByTimes, HoldsTheRestThatIsStatedAgainstThem) {
  axiometry::Test test = read_in_order_of(TestCycle::standard, 1.0);
  test.metadata.conditions.dwell = Duration::s(5.0);
  EXPECT_THAT(told_of(test),
              ElementsAre("the times of the readings are 1 s apart where they are nearest, expected more "
                          "than the rest of 5 s that is stated for each target"));
  test.metadata.conditions.dwell = Duration::s(1.4);
  EXPECT_THAT(told_of(test), IsEmpty()) << "times may be rounded";
}

TEST(OrderByTimes, IsADepartureOfTheTest) {
  EXPECT_FALSE(assess(read_in_order_of(TestCycle::step)).conforming());
  EXPECT_THAT(order_findings(read_in_order_of(TestCycle::step)), SizeIs(1));
}

}  // namespace
}  // namespace axiometry::iso230_2
