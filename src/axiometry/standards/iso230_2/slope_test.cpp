// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/slope.h"

#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::make_series;
using testing_support::none;

std::optional<Slope> slope_of(const Series& series) { return slope_of_means(evaluate_positions(series)); }

TEST(Slope, IsThatOfTheLineTheMeansLieOn) {
  const auto slope = slope_of(make_series({10, 30, 100}, {{3, 5, 12}}, {{1, 3, 10}}));
  EXPECT_DOUBLE_EQ(slope->per_position_native, 0.1);
  EXPECT_NEAR(slope->remainder.in_native(), 2.0, 1e-12) << "the reversal remains";
}

TEST(Slope, TakesTheMeansThereAre) {
  EXPECT_DOUBLE_EQ(slope_of(make_series({0, 10}, {{0, none}}, {{none, 5}}))->per_position_native, 0.5);
}

TEST(Slope, IsAbsentWhereDistancesVanish) { EXPECT_FALSE(slope_of(make_series({0, 1e-305}, {{0, 1}}, {}))); }

}  // namespace
}  // namespace axiometry::iso230_2
