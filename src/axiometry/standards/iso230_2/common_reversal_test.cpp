// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/common_reversal.h"

#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::make_series;
using testing_support::none;
using testing_support::RunDeviations;
namespace table2 = testing_support::table2;

TEST(CommonReversal, IsThatOfAllTargetsAndWhatRemainsIsThatOfEach) {
  const Series series = make_series({0, 1, 2}, {{1, 2, 6}, {2, 3, 7}}, {{6, 8, 13}, {7, 9, 14}});
  const auto found = common_reversal(evaluate_positions(series));  // B_i −5, −6, −7
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->remainder.in_native(), 1.0);
  EXPECT_DOUBLE_EQ(found->without.B_mean->in_native(), 0.0);
  const AxisParameters measured = evaluate(series).parameters;
  EXPECT_EQ(found->without.R_up, measured.R_up);
  EXPECT_EQ(found->without.R_down, measured.R_down);
}

TEST(CommonReversal, LeavesTheSameRemainderWhicheverWayItIsAskedFor) {
  const Series some = make_series({0, 1, 2}, {{1, 2, none}, {2.1, 3, 7}}, {{6, none, 13}, {7.3, 9, 14}});
  for (const Series& series : {table2::series(), some}) {
    const auto positions = evaluate_positions(series);
    const Deviation common = *evaluate(series).parameters.B_mean;
    EXPECT_EQ(reversal_remainder(positions, common), common_reversal(positions)->remainder);
  }
}

TEST(CommonReversal, LeavesWhatAnEvaluationOfMovedReadingsGives) {
  const Series series = table2::series();
  std::vector<RunDeviations> down = table2::down;
  for (RunDeviations& run : down)
    for (double& x : run) x += evaluate(series).parameters.B_mean->in_native();
  const AxisParameters expected = evaluate(make_series(table2::targets, table2::up, down)).parameters;
  const auto found = common_reversal(evaluate_positions(series));
  for (const ParameterInfo& parameter : parameters)
    EXPECT_NEAR((found->without.*parameter.member)->in_native(), (expected.*parameter.member)->in_native(), 1e-12)
        << parameter.key;
}

TEST(CommonReversal, NeedsATargetWithBothDirections) {
  EXPECT_FALSE(common_reversal(evaluate_positions(make_series({0, 1}, {{1, 2}}, {}))));
  EXPECT_FALSE(common_reversal(evaluate_positions(make_series({0, 1}, {{1, none}}, {{none, 2}}))));
}

}  // namespace
}  // namespace axiometry::iso230_2
