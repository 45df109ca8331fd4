// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/series/approaches.h"

#include <gtest/gtest.h>

#include <cmath>

namespace axiometry::formats {
namespace {

ListedReading approach(double target, Direction direction, std::size_t run, double deviation, double time_s,
                       std::size_t line) {
  return {Position::native(target), direction, run, Deviation::native(deviation), time_s, {line, 1}};
}

TEST(Approaches, ComeToTheirPlacesFromAnyOrder) {
  const std::vector<ListedReading> list = {approach(10, Direction::down, 2, 4, 7, 1),
                                           approach(0, Direction::up, 1, 1, 5, 2),
                                           approach(10, Direction::up, 1, 2, NAN, 3)};
  const auto result = gathered(list);
  ASSERT_TRUE(result) << result.error().to_string();
  EXPECT_EQ(result->series.targets()[0].in_native(), 0);
  EXPECT_EQ(result->series.reading(1, Direction::down, 1)->in_native(), 4);
  EXPECT_EQ(result->series.reading(1, Direction::up, 0)->in_native(), 2);
  EXPECT_FALSE(result->series.reading(0, Direction::down, 1));
  // Dense: direction, target, run; from the first reading on.
  ASSERT_EQ(result->times_s.size(), 8u);
  EXPECT_EQ(result->times_s[0], 0);
  EXPECT_TRUE(std::isnan(result->times_s[2]));
  EXPECT_EQ(result->times_s[7], 2);
}

TEST(Approaches, HaveNoTimesWhenNoneIsKnown) {
  const std::vector<ListedReading> list = {approach(0, Direction::up, 1, 1, NAN, 1),
                                           approach(1, Direction::up, 1, 1, NAN, 2)};
  EXPECT_TRUE(gathered(list)->times_s.empty());
}

TEST(Approaches, HaveNoTimesWhenTheseRunBackwards) {
  std::vector<ListedReading> list = {approach(0, Direction::up, 1, 1, 10, 1), approach(1, Direction::up, 1, 1, 20, 2),
                                     approach(1, Direction::up, 2, 1, NAN, 3), approach(0, Direction::up, 2, 1, 40, 4),
                                     approach(1, Direction::up, 3, 1, 19.5, 5)};
  const auto result = gathered(list);
  ASSERT_TRUE(result) << result.error().to_string();
  EXPECT_TRUE(result->times_s.empty());
  ASSERT_TRUE(result->remark);
  EXPECT_EQ(result->remark->message,
            "found time running backwards: run 3 is 0.5 s before run 1 at the same target; the "
            "times of the readings are left out");
  list[4].time_s = 20;
  EXPECT_FALSE(gathered(list)->remark) << "clocks of whole seconds repeat themselves";
}

TEST(Approaches, HaveNoTimesWhenTheseGoToAndFroWithinARun) {
  const std::vector<ListedReading> list = {
      approach(0, Direction::down, 2, 1, 30, 1), approach(1, Direction::down, 2, 1, 10, 2),
      approach(2, Direction::down, 2, 1, 15, 3), approach(2, Direction::up, 2, 1, 9, 4)};
  const auto result = gathered(list);
  ASSERT_TRUE(result) << result.error().to_string();
  EXPECT_TRUE(result->times_s.empty());
  ASSERT_TRUE(result->remark);
  EXPECT_EQ(result->remark->message,
            "found time running backwards: those of run 2 ↓ neither rise nor fall along the targets; the times of the "
            "readings are left out");
}

TEST(Approaches, AreRefusedWhenGivenTwice) {
  const std::vector<ListedReading> list = {approach(0.3, Direction::up, 1, 1, 0, 4),
                                           approach(1, Direction::up, 1, 1, 1, 5),
                                           approach(0.30000000000000004, Direction::up, 1, 2, 2, 6)};
  EXPECT_EQ(gathered(list).error().to_string(),
            "line 6:1: found a second reading of target 0.30000000000000004↑ run 1, expected only that on line 4");
}

}  // namespace
}  // namespace axiometry::formats
