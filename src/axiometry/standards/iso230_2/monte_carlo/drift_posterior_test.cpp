// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/drift_posterior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/standards/readings/test_course.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

constexpr std::size_t m = 7, n = 5;

/// An axis with a bow, scatter, and a drift along the time of the test.
axiometry::Test drifting(double trend, double scatter) {
  std::vector<Position> targets;
  for (std::size_t i = 0; i < m; ++i) targets.push_back(Position::native(100.0 * double(i)));
  std::vector<double> readings(2 * m * n), z(2 * m * n);
  numeric::fill_normal({3, 0, 0}, z);
  axiometry::Test test{{}, Series::make_dense(targets, n, readings).value(), {}};
  const TestCourse course = course_of(test);
  for (std::size_t r = 0; r < readings.size(); ++r)
    readings[r] = std::sin(double(r / n % m)) + trend * course.share[r] + scatter * z[r];
  test.series = Series::make_dense(targets, n, readings).value();
  return test;
}

EnvironmentModes shapes(EnvironmentKind kind, const axiometry::Test& test) {
  return environment_modes(kind, course_of(test).share, n);
}

TEST(DriftPosterior, FindsATrendThatWasStatedTooSmallOrTooLarge) {
  const axiometry::Test test = drifting(2.0, 0.1);
  const TestCourse course = course_of(test);
  for (double stated : {0.5, 2.0, 8.0}) {
    const DriftPosterior posterior(test.series, shapes(EnvironmentKind::drift, test), {stated}, MachineRuns::steady);
    const auto e = posterior.expected();
    double largest = 0.0;  // what all readings have in common is no part of it
    for (std::size_t r = 0; r < e.size(); ++r)
      largest = std::max(largest, std::abs(e[r] - e[0] - 2.0 * (course.share[r] - course.share[0])));
    EXPECT_LT(largest, 0.5) << stated;
  }
}

TEST(DriftPosterior, FindsLittleWhereTheReadingsDoNotDrift) {
  const axiometry::Test test = drifting(0.0, 0.3);
  const DriftPosterior posterior(test.series, shapes(EnvironmentKind::drift, test), {3.0}, MachineRuns::steady);
  EXPECT_LT(posterior.relative_size(), 0.5);
}

TEST(DriftPosterior, DrawsAboutWhatItExpects) {
  const axiometry::Test test = drifting(1.0, 0.2);
  const DriftPosterior posterior(test.series, shapes(EnvironmentKind::random_walk, test), {1.0}, MachineRuns::steady);
  constexpr std::size_t trials = 4000;
  std::vector<double> rows(2 * m * n * trials, 0.0);
  posterior.subtract_from_readings({1, 0, 0}, {rows, trials});
  for (std::size_t r = 0; r < 2 * m * n; ++r) {
    double sum = 0.0, squares = 0.0;
    for (std::size_t t = 0; t < trials; ++t) {
      sum += rows[r * trials + t] / trials;
      squares += rows[r * trials + t] * rows[r * trials + t] / trials;
    }
    EXPECT_NEAR(sum, 0.0, 5.0 * std::sqrt(squares / trials)) << r;
  }
}

/// Targets measured in runs 1 to 3, others in 4 to 6, one in all: the second set-up is shifted by that.
Series two_set_ups(double shift) {
  constexpr std::size_t targets = 21, runs = 6, shared = 10;
  std::vector<Position> places;
  for (std::size_t i = 0; i < targets; ++i) places.push_back(Position::native(10.0 * double(i)));
  std::vector<double> readings(2 * targets * runs);
  numeric::fill_normal({5, 0, 0}, readings);
  for (std::size_t r = 0; r < readings.size(); ++r) {
    const std::size_t i = r / runs % targets;
    const bool second = r % runs >= 3;
    if (second) readings[r] += shift;
    if (second ? i < shared : i > shared) readings[r] = std::nan("");
  }
  return Series::make_dense(places, runs, readings).value();
}

TEST(SeenModes, TakeShiftsOfTheRunsOutHoweverFewCellsTheyHaveInCommon) {
  const axiometry::Test still{{}, two_set_ups(0.0), {}};
  const axiometry::Test shifted{{}, two_set_ups(100.0), {}};
  const EnvironmentModes modes = environment_modes(EnvironmentKind::drift, course_of(still).share, 1);
  const SeenModes expected(still.series, modes, MachineRuns::shifting);
  const SeenModes found(shifted.series, modes, MachineRuns::shifting);
  EXPECT_EQ(found.degrees_of_freedom, 2 * (20 * 2 + 5) - 5);
  EXPECT_NEAR(found.squares, expected.squares, 1e-10 * expected.squares);
  EXPECT_NEAR(found.squares_left, expected.squares_left, 1e-10 * expected.squares);
}

TEST(DriftPosterior, HasNothingButWhatWasStatedForASingleApproach) {
  std::vector<Position> targets = {Position::native(0.0), Position::native(100.0), Position::native(200.0)};
  const axiometry::Test test{{}, Series::make_dense(targets, 1, {1, 2, 3, 4, 5, 6}).value(), {}};
  const auto modes = environment_modes(EnvironmentKind::drift, course_of(test).share, 1);
  const DriftPosterior posterior(test.series, modes, {1.0}, MachineRuns::steady);
  for (double e : posterior.expected()) EXPECT_EQ(e, 0.0);
}

}  // namespace
}  // namespace axiometry::iso230_2
