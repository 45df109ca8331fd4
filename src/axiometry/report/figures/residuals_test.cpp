// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/residuals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "axiometry/report/figures/figure_rules_test_support.h"

namespace axiometry::report {
namespace {

using ::testing::Contains;
using ::testing::Not;

constexpr const char* all_beyond = "readings, with all that lie beyond in the outermost bars";

std::vector<std::string> words_of(std::vector<double> residuals) {
  return testing::all_words(residual_figure(residuals, {}).value());
}

TEST(ResidualFigure, SaysThatItsOutermostBarsHoldWhatLiesBeyondWhereTheyDo) {
  const std::vector<double> within = {-3.1, -2.0, -1.1, -0.6, -0.2, 0.1, 0.4, 0.8, 1.9, 5.9};
  EXPECT_THAT(words_of(within), Contains("readings"));
  std::vector<double> beyond = within;
  beyond.back() = -6.1;
  EXPECT_THAT(words_of(beyond), Contains(all_beyond));
  EXPECT_THAT(words_of(beyond), Not(Contains("readings")));
}

}  // namespace
}  // namespace axiometry::report
