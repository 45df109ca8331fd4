// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/gross_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

std::vector<GrossError> found_in(const Series& series) {
  return gross_errors(series, course_of(axiometry::Test{{}, series, {}}), step_of(series));
}

Series scattering(std::uint64_t block, std::size_t n, const auto& change) {
  constexpr std::size_t m = 9;
  std::vector<Position> targets;
  for (std::size_t i = 0; i < m; ++i) targets.push_back(Position::native(100.0 * double(i)));
  std::vector<double> readings(2 * m * n);
  numeric::fill_normal({8, 0, block}, readings);
  for (std::size_t r = 0; r < readings.size(); ++r) readings[r] += 20.0 * std::sin(double(r / n)) + change(r);
  return Series::make_dense(targets, n, readings).value();
}

TEST(GrossErrors, AreRareWhereThereAreNone) {
  for (std::size_t n : {3u, 5u, 10u}) {
    int alarms = 0;
    for (std::uint64_t k = 0; k < 400; ++k) alarms += !found_in(scattering(k, n, [](auto) { return 0.0; })).empty();
    EXPECT_LE(alarms, 12) << n;  // one in a hundred, and four times the root of four
  }
}

TEST(GrossErrors, AreNamed) {
  const auto found = found_in(scattering(3, 5, [](std::size_t r) { return r == 5 * 11 + 3 ? -9.0 : 0.0; }));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].direction, Direction::down);
  EXPECT_EQ(found[0].target, 2u);
  EXPECT_EQ(found[0].run, 3u);
  EXPECT_LT(found[0].departure.in_native(), -6.0);
}

TEST(GrossErrors, AreNoShiftsOfWholeRuns) {
  EXPECT_TRUE(found_in(scattering(5, 5, [](std::size_t r) { return r % 5 == 0 ? 30.0 : 0.0; })).empty());
}

TEST(GrossErrors, AreNotMadeByTheStepsOfADisplay) {
  std::vector<double> readings(2 * 3 * 5, 0.0);
  readings[7] = 0.1;  // one digit
  const std::vector<Position> targets = {Position::native(0.0), Position::native(1.0), Position::native(2.0)};
  EXPECT_TRUE(found_in(Series::make_dense(targets, 5, readings).value()).empty());
}

/// A second one must not hide the first.
TEST(GrossErrors, AreNamedWhereOneCellHasTwo) {
  for (double second : {50.0, -50.0}) {
    const auto found = found_in(scattering(7, 5, [&](std::size_t r) {
      return r == 5 * 4 ? 50.0 : r == 5 * 4 + 3 ? second : 0.0;
    }));
    ASSERT_EQ(found.size(), 2u) << second;
    for (const GrossError& each : found) EXPECT_EQ(each.target, 4u);
  }
}

/// Of three approaches one error makes every departure of its cell large: six of them a third of all.
TEST(GrossErrors, AreNamedWhereTheyAreInManyCells) {
  for (std::uint64_t k = 0; k < 20; ++k) {
    const auto found = found_in(scattering(900 + k, 3, [](std::size_t r) {
      const std::size_t cell = r / 3;
      return cell % 3 != 0 || r % 3 != cell / 3 % 3 ? 0.0 : cell % 2 == 0 ? 10.0 : -10.0;
    }));
    EXPECT_FALSE(found.empty()) << k;
  }
}

TEST(GrossErrors, AreNamedAmongReadingsThatAreAllAlike) {
  std::vector<double> readings(2 * 3 * 5, 1.0);
  readings[7] = 500.0;
  const std::vector<Position> targets = {Position::native(0.0), Position::native(1.0), Position::native(2.0)};
  EXPECT_EQ(found_in(Series::make_dense(targets, 5, readings).value()).size(), 1u);
}

TEST(GrossErrors, AreNotMadeByRounding) {
  std::vector<double> readings(2 * 3 * 5, 1.0);
  readings[7] += 1e-6;
  const std::vector<Position> targets = {Position::native(0.0), Position::native(1.0), Position::native(2.0)};
  EXPECT_TRUE(found_in(Series::make_dense(targets, 5, readings).value()).empty());
}

TEST(GrossErrors, NeedTwoApproaches) {
  EXPECT_TRUE(found_in(testing_support::make_series({0, 10, 20}, {{0, 100, 2}}, {{1, 2, 300}})).empty());
}

}  // namespace
}  // namespace axiometry::iso230_2
