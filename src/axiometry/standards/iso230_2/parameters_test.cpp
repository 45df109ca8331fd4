// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/parameters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::make_series;

using testing_support::none;

TEST(Evaluate, AddsTheTermsOfBidirectionalRepeatabilityLinearly) {
  // s = 1 in both directions, B_i = −4: 2 + 2 + 4.
  const Series series =
      make_series({0, 1}, {{1, 1}, {-1, -1}, {1, 1}, {-1, -1}, {0, 0}}, {{5, 5}, {3, 3}, {5, 5}, {3, 3}, {4, 4}});
  const Evaluation e = evaluate(series);
  EXPECT_DOUBLE_EQ(e.positions[0].R->in_native(), 8.0);
  EXPECT_DOUBLE_EQ(e.parameters.R->in_native(), 8.0);
}

TEST(Evaluate, KeepsTheSignOfTheMeanReversalAndNotThatOfB) {
  const AxisParameters p = evaluate(make_series({0, 1}, {{0, 0}}, {{3, 1}})).parameters;
  EXPECT_DOUBLE_EQ(p.B->in_native(), 3.0);
  EXPECT_DOUBLE_EQ(p.B_mean->in_native(), -2.0);
}

TEST(Evaluate, LeavesOutWhatNeedsTheOtherDirection) {
  const Evaluation e = evaluate(make_series({0, 1}, {{0, 1}, {1, 1}}, {}));
  const AxisParameters& p = e.parameters;
  EXPECT_TRUE(p.A_up && p.E_up && p.R_up);
  for (const auto& absent : {p.A, p.A_down, p.E, p.E_down, p.M, p.R, p.R_down, p.B, p.B_mean}) EXPECT_FALSE(absent);
  EXPECT_TRUE(e.positions[0].R_up);
  EXPECT_FALSE(e.positions[0].R) << "R_i needs B_i";
}

TEST(Evaluate, GivesNoBidirectionalRepeatabilityAtATargetWithoutBothEstimators) {
  // Target 2 was reached once from below: s_2↑ does not exist, so R_2 does not; R of the axis has it as a bound.
  const Evaluation e = evaluate(make_series({0, 1}, {{0, 9}, {0, none}}, {{0, 0}, {0, 2}}));
  EXPECT_TRUE(e.positions[0].R);
  EXPECT_TRUE(e.positions[1].reversal && e.positions[1].s_down);
  EXPECT_FALSE(e.positions[1].s_up);
  EXPECT_FALSE(e.positions[1].R);
  EXPECT_GT(e.parameters.R->in_native(), 8.0);
  EXPECT_FALSE(with_estimators(e.positions[0], e.positions[0].s_up, {}).R);
}

TEST(Evaluate, TakesZeroForAnEstimatorThatIsMissingAtOneTarget) {
  // Target 2 was reached once from above: no s there, yet the bound of A holds its mean.
  const Evaluation e = evaluate(make_series({0, 1}, {{0, 0}, {1, 1}}, {{0, 9}, {1, none}}));
  EXPECT_FALSE(e.positions[1].s_down);
  EXPECT_DOUBLE_EQ(e.parameters.E_down->in_native(), 8.5);
  const double s = std::sqrt(0.5);
  EXPECT_DOUBLE_EQ(e.parameters.A_down->in_native(), 9.0 - (0.5 - 2 * s));
  EXPECT_FALSE(e.positions[1].R) << "but the axis counts it, as a lower bound";
}

TEST(Evaluate, CountsTheReadingsOfEveryTarget) {
  const auto positions = evaluate(make_series({0, 1}, {{0, 0}, {1, none}}, {{0, 9}})).positions;
  EXPECT_EQ(positions[0].count_up, 2u);
  EXPECT_EQ(positions[1].count_up, 1u);
  EXPECT_EQ(positions[1].count_down, 1u);
}

TEST(Evaluate, HasNoScatterForEqualReadings) {
  const AxisParameters p = evaluate(make_series({0, 1}, {{0.1, 0.1}, {0.1, 0.1}}, {{0.1, 0.1}, {0.1, 0.1}})).parameters;
  EXPECT_EQ(p.R->in_native(), 0.0);
  EXPECT_EQ(p.A->in_native(), 0.0);
}

TEST(Evaluate, SurvivesTheLargestReadings) {
  const AxisParameters p =
      evaluate(make_series({0, 1}, {{1e9, -1e9}, {1e9, -1e9}}, {{-1e9, 1e9}, {-1e9, 1e9}})).parameters;
  EXPECT_DOUBLE_EQ(p.A->in_native(), 2e9);
  EXPECT_DOUBLE_EQ(p.R->in_native(), 2e9);
}

TEST(AxisWithoutOne, GivesWhatAnEvaluationOfTheSeriesWithoutTheReadingGives) {
  const std::vector<testing_support::RunDeviations> down{{2, 3, 4}, {1, 9, 2}};
  const std::vector<PositionResult> positions =
      evaluate_positions(make_series({0, 1, 2}, {{1, 2, 40}, {7, 8, 1}, {2, 2, 3}}, down));
  const AxisWithoutOne axis(positions);
  const Evaluation without = evaluate(make_series({0, 1, 2}, {{1, 2, none}, {7, 8, 1}, {2, 2, 3}}, down));
  const AxisParameters exchanged = axis.with(2, without.positions[2]);
  for (const ParameterInfo& parameter : parameters)
    EXPECT_EQ(exchanged.*parameter.member, without.parameters.*parameter.member) << parameter.key;
  EXPECT_NE(exchanged.A, evaluate_axis(positions).A);
}

TEST(WithEstimators, FollowsThreeNineteenAndThreeTwenty) {
  PositionResult p = evaluate(make_series({0, 1}, {{0, 0}, {1, 1}}, {{3, 3}, {4, 4}})).positions[0];
  p = with_estimators(p, Deviation::native(0.5), Deviation::native(2.0));
  EXPECT_DOUBLE_EQ(p.R_up->in_native(), 2.0);
  EXPECT_DOUBLE_EQ(p.R_down->in_native(), 8.0);
  EXPECT_DOUBLE_EQ(p.R->in_native(), 8.0);
}

TEST(Parameters, AreTheTwelveOfTheStandardByUniqueKeys) {
  EXPECT_EQ(std::size(parameters), 12u);
  for (std::size_t a = 0; a < std::size(parameters); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_NE(parameters[a].key, parameters[b].key);
}

TEST(Parameters, AreBelowZeroWhereTheyMayBeAlone) {
  const AxisParameters found = evaluate(make_series({0, 1}, {{-3, -9}, {-4, -8}}, {{-1, -2}, {-2, -3}})).parameters;
  for (const ParameterInfo& parameter : parameters)
    EXPECT_EQ((found.*parameter.member)->in_native() < 0.0, may_be_below_0(parameter.key)) << parameter.key;
}

}  // namespace
}  // namespace axiometry::iso230_2
