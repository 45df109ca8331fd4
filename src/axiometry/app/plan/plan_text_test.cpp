// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/plan/plan_text.h"

#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

template <typename T>
std::string refusal(const Result<T>& result) {
  return result ? "" : result.error().message;
}

TEST(PlanText, ReadsAStretch) {
  EXPECT_EQ(parse_stretch("-300:450.5")->from, Position::native(-300));
  EXPECT_EQ(parse_stretch("-300:450.5")->to, Position::native(450.5));
  for (std::string_view bad : {"", "5", "1:2:3", "a:b", "1:", "nan:3", "1..2"})
    EXPECT_NE(refusal(parse_stretch(bad)), "") << bad;
}

TEST(PlanText, AnAreaEndsWhereTheNormalStretchDoes) {
  EXPECT_EQ(parse_area("1000", AxisKind::linear)->to, Position::native(3000));
  EXPECT_EQ(parse_area("720", AxisKind::rotary)->to, Position::native(1080));
  EXPECT_EQ(parse_area("1000:1500", AxisKind::linear)->to, Position::native(1500));
}

TEST(PlanText, ReadsPositionsAndRangesOfThem) {
  EXPECT_EQ(*parse_positions("0, 12.5,-40"), (std::vector<double>{0, 12.5, -40}));
  EXPECT_EQ(*parse_positions("0:1:0.1"), (std::vector<double>{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}));
  EXPECT_EQ(*parse_positions("0:100:40,7"), (std::vector<double>{0, 40, 80, 7}));
  for (std::string_view bad : {"", "1,,2", "0:10", "0:10:0", "0:10:-1", "10:0:1", "0:1e6:1e-6", "0:inf:1", "x"})
    EXPECT_NE(refusal(parse_positions(bad)), "") << bad;
}

TEST(PlanText, CountsPositionsBeforeItMakesThem) {
  EXPECT_EQ(refusal(parse_positions("0:500:1e-3")),
            "found \"0:500:1e-3\", 500001 positions in all, expected at most 10000");
  EXPECT_EQ(refusal(parse_positions("0:1:1e-300")),
            "found \"0:1:1e-300\", 1e+300 positions in all, expected at most 10000");
  EXPECT_EQ(parse_positions("0:9999:1")->size(), 10'000U);
  EXPECT_NE(refusal(parse_positions("0:9999:1,0")), "");
  std::string approaches = "1+";
  for (int k = 0; k < 100'000; ++k) approaches += " 1-";
  EXPECT_EQ(refusal(parse_sequence(approaches)), "found more than 100000 approaches, expected at most 100000");
}

TEST(PlanText, CountsTheRunsOfASequence) {
  const auto sequence = parse_sequence("1+ 2+, 2-\n1+ # again from below\n");
  ASSERT_TRUE(sequence);
  EXPECT_EQ(*sequence,
            (std::vector<Approach>{
                {0, Direction::up, 0}, {1, Direction::up, 0}, {1, Direction::down, 0}, {0, Direction::up, 1}}));
  for (std::string_view bad : {"", "# nothing", "1", "+", "0+", "1*", "1+2+", "-1+"})
    EXPECT_NE(refusal(parse_sequence(bad)), "") << bad;
}

}  // namespace
}  // namespace axiometry::app
