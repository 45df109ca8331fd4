// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/drift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/series.h"

namespace axiometry {
namespace {

using Measured = axiometry::Test;  // within a TEST, Test is the fixture

using testing_support::none;

/// Readings that are errors of the machine plus 6 µm over the test.
Measured drifting() {
  Measured test{{},
                testing_support::make_series({0, 100, 200}, {{5, -3, 8}, {5, -3, 8}, {5, -3, 8}},
                                             {{-4, 2, 1}, {-4, 2, 1}, {-4, none, 1}}),
                {}};
  const TestCourse course = course_of(test);
  std::vector<double> deviations;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const double x = test.series.cell(i, direction)[j];
        deviations.push_back(x + 6.0 * course.at(test.series, i, direction, j));
      }
  test.series =
      Series::make_dense({Position::native(0), Position::native(100), Position::native(200)}, 3, deviations).value();
  return test;
}

TEST(Drift, IsFoundUnderTheErrorsOfTheMachine) {
  const auto drift = drift_of(drifting());
  ASSERT_TRUE(drift);
  EXPECT_NEAR(drift->over_test.in_native(), 6.0, 1e-12);
  EXPECT_NEAR(drift->u->in_native(), 0.0, 1e-12);
  EXPECT_EQ(drift->degrees_of_freedom, 3u - 2u);
  EXPECT_NEAR(drift->per_reading(drift->over_test), 6.0 / 17.0, 1e-12);
  EXPECT_FALSE(drift->per_hour(drift->over_test));
}

TEST(Drift, IsARatePerHourWhereTimesAreKnown) {
  Measured test = drifting();
  const TestCourse course = course_of(test);
  for (const double share : course.share) test.times_s.push_back(1e9 + 1800.0 * share);
  EXPECT_NEAR(drift_of(test)->per_hour(drift_of(test)->over_test).value(), 12.0, 1e-5);
}

TEST(Drift, IsUnknownWhereNobodyKnowsTheOrder) {
  Measured test = drifting();
  const TestCourse course = course_of(test);
  test.metadata.conditions.cycle = TestCycle::user_defined;
  EXPECT_FALSE(drift_of(test));
  for (const double share : course.share) test.times_s.push_back(1e9 + 1800.0 * share);
  EXPECT_TRUE(drift_of(test)) << "times tell it";
}

// Golden: numpy.linalg.lstsq of ISO 230-2, Table 2 with 22 constants; u from the means of its runs about their line,
// whose shifts the test has.
TEST(Drift, HasTheLeastSquaresEstimateAndItsUncertainty) {
  const auto drift = drift_of({{}, testing_support::table2::series(), {}});
  ASSERT_TRUE(drift);
  EXPECT_NEAR(drift->over_test.in_native(), -0.2815082644628112, 1e-9);
  EXPECT_NEAR(drift->u->in_native(), 0.8099583258843761, 1e-9);
  EXPECT_EQ(drift->degrees_of_freedom, 3u);
}

TEST(Drift, IsNoMoreCertainForTenTargetsOfRunsThatShiftAsAWhole) {
  const double shifts[] = {0.0, 1.0, -1.0, 0.5, 0.25};
  const auto u_on = [&](std::size_t targets) {
    std::vector<double> places;
    std::vector<testing_support::RunDeviations> runs;
    for (std::size_t i = 0; i < targets; ++i) places.push_back(10.0 * static_cast<double>(i));
    for (const double shift : shifts) runs.emplace_back(targets, shift);
    return drift_of({{}, testing_support::make_series(places, runs, {}), {}})->u->in_native();
  };
  EXPECT_GT(u_on(20), 0.8);
  EXPECT_NEAR(u_on(20), u_on(10), 0.1 * u_on(10));
}

TEST(Drift, CannotBeToldFromASingleApproach) {
  EXPECT_FALSE(drift_of({{}, testing_support::make_series({0, 100, 200}, {{1, 2, 3}}, {{2, 3, 4}}), {}}));
}

TEST(Drift, HasNoUncertaintyWithoutADegreeOfFreedom) {
  const auto drift = drift_of({{}, testing_support::make_series({0, 100}, {{1, 2}, {3, none}}, {}), {}});
  ASSERT_TRUE(drift);
  EXPECT_NEAR(drift->over_test.in_native(), 3.0, 1e-12);
  EXPECT_FALSE(drift->u);
  EXPECT_EQ(drift->degrees_of_freedom, 0u);
}

}  // namespace
}  // namespace axiometry
