// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::compensation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<double> uneven{0.4, 26.1, 49.3, 76.2, 99.8};

TEST(GridOf, TakesTheTargetsWhereTheControlDoes) { EXPECT_EQ(*grid_of(uneven, {}, {}), uneven); }

TEST(GridOf, TakesRoundStepsWithinTheTargetsWhereTheSpacingMustBeEven) {
  // Steps of 20 or 10 would leave more than 2.5 mm beyond the ends.
  const auto grid = *grid_of(uneven, {}, {.equidistant = true});
  EXPECT_DOUBLE_EQ(grid.front(), 2.5);
  EXPECT_DOUBLE_EQ(grid.back(), 97.5);
  EXPECT_DOUBLE_EQ(grid[1] - grid[0], 2.5);
  EXPECT_THAT(*grid_of(std::vector<double>{0, 30, 60}, {}, {.equidistant = true}), ElementsAre(0, 30, 60));
  EXPECT_THAT(*grid_of(std::vector<double>{0, 29, 60}, {}, {.equidistant = true}), ElementsAre(0, 20, 40, 60));
}

TEST(GridOf, WidensTheStepUntilTheControlCanHoldIt) {
  std::vector<double> many;
  for (int i = 0; i <= 1000; ++i) many.push_back(i);
  const auto grid = grid_of(many, {}, {.points = 256});
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->size(), 201u);
  EXPECT_DOUBLE_EQ((*grid)[1], 5.0);
}

TEST(GridOf, TakesWhatTheUserSays) {
  EXPECT_THAT(*grid_of(uneven, {.start = 1, .end = 99, .step = 49}, {}), ElementsAre(1, 50, 99));
  EXPECT_THAT(*grid_of(uneven, {.start = 10, .end = 90, .points = 3}, {}), ElementsAre(10, 50, 90));
  EXPECT_THAT(*grid_of(uneven, {.step = 25}, {}), ElementsAre(25, 50, 75));
  EXPECT_THAT(*grid_of(uneven, {.start = 5, .step = 25}, {}), ElementsAre(5, 30, 55, 80));
}

TEST(GridOf, TakesAsManyPointsAsTheControlHolds) {
  // 1500/999 as a step leads to a whole number of them but for rounding.
  const std::vector<double> long_axis{0.0, 700.0, 1600.0};
  for (const std::size_t most : {256uz, 1000uz, 1500uz}) {
    const auto grid = grid_of(long_axis, {.start = 0.0, .end = 1500.0, .points = most}, {.points = most});
    ASSERT_TRUE(grid) << grid.error().message;
    EXPECT_EQ(grid->size(), most);
  }
}

TEST(GridOf, BeginsAtAReferencePointAndKeepsAFixedStep) {
  EXPECT_THAT(
      *grid_of(std::vector<double>{-60, -30, 0}, {.end = 0}, {.equidistant = true, .step = 12.7, .anchor = 0.0}),
      ElementsAre(-50.8, -38.1, -25.4, -12.7, 0));
}

TEST(GridOf, RefusesWhatContradictsItself) {
  const auto fault = [](const GridRequest& request, const GridLimits& limits = {}) -> std::string {
    const auto grid = grid_of(uneven, request, limits);
    return grid ? "" : grid.error().message;
  };
  EXPECT_THAT(fault({.step = 0.0}), HasSubstr("expected one above 0"));
  EXPECT_THAT(fault({.start = 50, .end = 10, .step = 5}), HasSubstr("expected one above the start at 50"));
  EXPECT_THAT(fault({.start = 0, .end = 100, .step = 30}), HasSubstr("whole number"));
  EXPECT_THAT(fault({.start = 0, .end = 100, .step = 30, .points = 3}), HasSubstr("would be steps"));
  EXPECT_THAT(fault({.points = 1}), HasSubstr("at least two"));
  EXPECT_THAT(fault({.step = 1e-9}), HasSubstr("expected at most"));
  EXPECT_THAT(fault({.step = 0.1}, {.points = 256}), HasSubstr("expected at most 256"));
}

}  // namespace
}  // namespace axiometry::compensation
