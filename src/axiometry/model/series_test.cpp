// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace axiometry {
namespace {

using testing::HasSubstr;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<Position> at(std::initializer_list<double> positions) {
  std::vector<Position> targets;
  for (double p : positions) targets.push_back(Position::native(p));
  return targets;
}

Reading reading(std::size_t target, std::size_t run, double deviation, Direction direction = Direction::up) {
  return {target, direction, run, Deviation::native(deviation)};
}

std::string refusal(std::vector<Position> targets, const std::vector<Reading>& readings) {
  const auto series = Series::make(std::move(targets), readings);
  return series ? "" : series.error().message;
}

TEST(Series, KeepsReadingsWhereTheyWereTaken) {
  const auto series =
      Series::make(at({0, 10}), std::vector{reading(0, 0, 1), reading(1, 1, 2), reading(1, 0, -3, Direction::down)});
  ASSERT_TRUE(series);
  EXPECT_EQ(series->run_count(), 2u);
  EXPECT_EQ(series->reading_count(), 3u);
  EXPECT_EQ(series->reading(1, Direction::up, 1), Deviation::native(2));
  EXPECT_EQ(series->reading(1, Direction::up, 0), std::nullopt);
  EXPECT_EQ(series->reading(1, Direction::down, 0), Deviation::native(-3));
  EXPECT_EQ(series->count(0, Direction::down), 0u);
  EXPECT_TRUE(series->has(Direction::down));
}

TEST(Series, RefusesTargetsThatDoNotAscend) {
  EXPECT_THAT(refusal(at({5}), {reading(0, 0, 1)}), HasSubstr("found 1 target position, expected at least 2"));
  EXPECT_THAT(refusal(at({0, 0}), {reading(0, 0, 1)}), HasSubstr("expected ascending positions"));
  EXPECT_THAT(refusal(at({0, none}), {reading(0, 0, 1)}), HasSubstr("expected a magnitude up to 1e9"));
  EXPECT_THAT(refusal(at({0, 2e9}), {reading(0, 0, 1)}), HasSubstr("target 2 at 2000000000"));
}

TEST(Series, RefusesReadingsThatAreNone) {
  EXPECT_THAT(refusal(at({0, 10}), {reading(0, 0, none)}), HasSubstr("not finite at target 0↑ run 1"));
  EXPECT_THAT(refusal(at({0, 10}), {reading(0, 0, 1), reading(1, 0, 2e9, Direction::down)}),
              HasSubstr("found deviation 2000000000 at target 10↓ run 1"));
  EXPECT_THAT(refusal(at({0, 10}), {reading(0, 0, 1), reading(0, 0, 1)}), HasSubstr("second reading of target 0↑"));
  EXPECT_THAT(refusal(at({0, 10}), {reading(2, 0, 1)}), HasSubstr("target number 3, expected at most 2"));
  EXPECT_THAT(refusal(at({0, 10}), {reading(0, 0, 1)}), HasSubstr("found no reading at target 10"));
}

TEST(Series, RefusesRunsBeyondAnyTest) {
  for (std::size_t run : {std::size_t{1} << 27, std::numeric_limits<std::size_t>::max()})
    EXPECT_THAT(refusal(at({0, 10}), {reading(0, run, 1)}), HasSubstr("expected one below 67108864"));
}

TEST(Series, RefusesADenseFormOfAnotherSize) {
  EXPECT_TRUE(Series::make_dense(at({0, 10}), 1, {1, 2, none, none}));
  EXPECT_FALSE(Series::make_dense(at({0, 10}), 1, {1, 2, 3}));
  EXPECT_FALSE(Series::make_dense(at({0, 10}), 2, {1, 2, none, none}));
  const std::size_t wraps_to_nothing = std::size_t{1} << 62;
  EXPECT_FALSE(Series::make_dense(at({0, 10}), wraps_to_nothing, {}));
}

}  // namespace
}  // namespace axiometry
