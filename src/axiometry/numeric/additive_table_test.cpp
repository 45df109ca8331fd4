// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/additive_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace axiometry::numeric {
namespace {

constexpr double gone = std::numeric_limits<double>::quiet_NaN();

TEST(AdditiveTable, FindsLevelsAndShiftsOfAFullTable) {
  const std::vector<double> table = {1.0, 2.0, 6.0, 11.0, 12.0, 16.0};
  const AdditiveFit fit = fit_additive(table, 3);
  EXPECT_NEAR(fit.squares, 0.0, 1e-20);
  EXPECT_EQ(fit.degrees, 2.0);
  EXPECT_NEAR(fit.levels[1] - fit.levels[0], 10.0, 1e-12);
  EXPECT_NEAR(fit.shifts[2] - fit.shifts[0], 5.0, 1e-12);
  EXPECT_NEAR(fit.shifts[0] + fit.shifts[1] + fit.shifts[2], 0.0, 1e-12);
}

TEST(AdditiveTable, LeavesOutWhatIsMissing) {
  const std::vector<double> table = {1.0, gone, 6.0, 11.0, 12.0, 16.0, gone, 7.0, 11.0};
  const AdditiveFit fit = fit_additive(table, 3);
  EXPECT_NEAR(fit.squares, 0.0, 1e-18) << "the values are additive where they are";
  EXPECT_EQ(fit.degrees, 2.0);
  EXPECT_EQ(fit.count, 7u);
  EXPECT_TRUE(std::isnan(fit.residuals[1]));
}

// By hand: of 2 × 2 values the residuals are a quarter of the interaction.
TEST(AdditiveTable, LeavesTheInteraction) {
  const AdditiveFit fit = fit_additive(std::vector<double>{0.0, 0.0, 0.0, 4.0}, 2);
  EXPECT_NEAR(fit.residuals[3], 1.0, 1e-12);
  EXPECT_NEAR(fit.squares, 4.0, 1e-12);
  EXPECT_NEAR(fit.share(0, 0), 0.25, 1e-15);
}

TEST(AdditiveTable, StandsRowsAndColumnsWithoutValues) {
  const AdditiveFit fit = fit_additive(std::vector<double>{1.0, gone, gone, gone}, 2);
  EXPECT_EQ(fit.degrees, 0.0);
  EXPECT_TRUE(std::isnan(fit.levels[1]));
  EXPECT_TRUE(std::isnan(fit.shifts[1]));
}

}  // namespace
}  // namespace axiometry::numeric
