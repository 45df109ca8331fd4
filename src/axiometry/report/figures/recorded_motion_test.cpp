// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/recorded_motion.h"

#include <gtest/gtest.h>

#include "axiometry/report/figures/figure_rules_test_support.h"

namespace axiometry::report {
namespace {

std::size_t numbers_upwards(const Figure& figure) {
  std::size_t count = 0;
  for (const Operation& operation : figure.operations)
    if (const auto* text = std::get_if<Text>(&operation)) count += text->anchor == Anchor::end ? 1 : 0;
  return count;
}

TEST(RecordedMotionFigure, HasAScaleAndItsWholeTitleWhateverTheRange) {
  for (const double lowest : {-480.0, -101.0, 0.0, 3.0, 480.0})
    for (const double range : {0.9, 7.0, 60.0, 480.0, 882.0, 1001.0}) {
      const Figure figure = recorded_figure({.title = "Acceleration over time",
                                             .description = "",
                                             .x_title = "Time",
                                             .x_unit = "s",
                                             .y_title = "Geschwindigkeit",
                                             .y_unit = "mm/s²",
                                             .lines = {{{0.0, lowest}, {1.0, lowest + range}}},
                                             .shaded = {}},
                                            {});
      EXPECT_GE(numbers_upwards(figure), 2u) << lowest << " and " << range;
      EXPECT_EQ(testing::fault_of(figure), "") << lowest << " and " << range;
    }
}

}  // namespace
}  // namespace axiometry::report
