// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "axiometry/report/conformity_text.h"
#include "axiometry/report/shown_number.h"
#include "tests/support/report_subject.h"

namespace axiometry::report {
namespace {

using testing_support::Reported;
using testing_support::reported_table2;

const iso230_2::ParameterInfo& parameter(std::string_view key) { return *testing_support::tolerance(key, 0).parameter; }

ShownParameter shown(const Reported& reported, std::string_view key, AxisKind kind = AxisKind::linear) {
  return show(parameter(key), reported.assessment, kind, reported.options);
}

TEST(Show, EndsTheValueWhereItsUncertaintyEnds) {
  const Reported table2 = reported_table2();
  EXPECT_EQ(shown(table2, "A").value, "9.6");
  EXPECT_EQ(shown(table2, "A").U, "4.3");
  EXPECT_EQ(shown(table2, "B").value, "4.12");
  EXPECT_EQ(shown(table2, "B").U, "0.92");
  EXPECT_EQ(shown(table2, "B_mean").value, "\u22123.71");
}

TEST(Show, UsesTheDecimalsOfDeviationsWithoutUncertainty) {
  Reported bare = testing_support::reported_without_metadata();
  EXPECT_EQ(shown(bare, "A").value, "9.6");
  EXPECT_EQ(shown(bare, "A").U, "");
  bare.options.deviation_decimals = 3;
  EXPECT_EQ(shown(bare, "A").value, "9.586");
}

TEST(Show, ConvertsIntoTheDisplayUnit) {
  Reported bare = testing_support::reported_without_metadata();
  bare.options = {.numbers = {','}, .unit = DisplayUnit::mm, .deviation_decimals = {}};
  EXPECT_EQ(shown(bare, "A").value, "0,0096");
  EXPECT_EQ(shown(bare, "A").unit, "mm");
  bare.options.unit = DisplayUnit::nm;
  EXPECT_EQ(shown(bare, "A").value, "9586");
}

TEST(Show, KeepsTheNativeUnitWhenTheChosenOneBelongsToTheOtherKindOfAxis) {
  Reported bare = testing_support::reported_without_metadata();
  bare.options.unit = DisplayUnit::deg;
  EXPECT_EQ(shown(bare, "A").unit, "µm");
  bare.options.unit = DisplayUnit::mm;
  EXPECT_EQ(shown(bare, "A", AxisKind::rotary).unit, "″");
  bare.options.unit = DisplayUnit::deg;
  EXPECT_EQ(shown(bare, "A", AxisKind::rotary).value, "0.00266");
}

TEST(Show, HonoursTheDigitsOfTheUncertainty) {
  Reported table2 = reported_table2();
  table2.options.uncertainty_digits = 3;
  EXPECT_EQ(shown(table2, "A").value, "9.59");
  EXPECT_EQ(shown(table2, "A").U, "4.27");
}

TEST(Show, RoundsALargeUncertaintyToItsDigitsToo) {
  Reported table2 = reported_table2();
  table2.options.unit = DisplayUnit::nm;
  EXPECT_EQ(shown(table2, "A").value, "9600");
  EXPECT_EQ(shown(table2, "A").U, "4300");
}

TEST(Show, TellsBesideALimitOnWhichSideOfItTheValueLies) {
  const Reported bare = testing_support::reported_without_metadata();  // A = 9.586…
  const auto beside = [&](double limit) {
    iso230_2::Judgement judgement{};
    judgement.tolerance = testing_support::tolerance("A", limit);
    judgement.magnitude = bare.assessment.evaluation.parameters.A;
    return show(judgement, bare.assessment, AxisKind::linear, bare.options).value;
  };
  EXPECT_EQ(beside(10.0), "9.6");
  EXPECT_EQ(beside(9.6), "9.59") << "less than its limit";
  EXPECT_EQ(beside(9.5), "9.6");
}

/// A = 9.586…: what T − g and T + g show beside it must not contradict the verdict.
TEST(Show, TellsOnWhichSideOfTheGuardBandTheValueLies) {
  Reported bare = testing_support::reported_without_metadata();
  const auto beside = [&](double limit, double guard_band) {
    iso230_2::Judgement judgement{};
    judgement.tolerance = testing_support::tolerance("A", limit);
    judgement.rule = {uncertainty::DecisionRule::Kind::guard_band, guard_band};
    judgement.magnitude = bare.assessment.evaluation.parameters.A;
    judgement.uncertainty = iso230_2::StatedUncertainty{};
    judgement.decision.guard_band = judgement.decision.rejection_band = guard_band;
    return show(judgement, bare.assessment, AxisKind::linear, bare.options);
  };
  EXPECT_EQ(beside(20.0, 1.0).value, "9.6");
  EXPECT_EQ(beside(10.0, 0.41).value, "9.586") << "accepted up to 9.59, where 9.59 of 9.590 would seem to be at it";
  EXPECT_EQ(beside(10.0, 0.45).value, "9.6") << "undecided above 9.55";
  EXPECT_EQ(beside(9.0, 0.59).value, "9.586") << "rejected above 9.59 only";
  EXPECT_EQ(limit_decimals(beside(20.0, 1.0)), 2);
  bare.options.unit = DisplayUnit::nm;
  EXPECT_EQ(limit_decimals(beside(20.0, 1.0)), 1);
}

// 10 − 3.5122… and 10 + 3.5122…
TEST(Show, RoundsTheGuardBandSoThatNothingSeemsAcceptedOrRejectedThatIsNot) {
  EXPECT_DOUBLE_EQ(acceptance_limit_to(6.487771786493827, 2), 6.48);
  EXPECT_DOUBLE_EQ(rejection_limit_to(13.512228213506173, 2), 13.52);
  EXPECT_DOUBLE_EQ(acceptance_limit_to(6.4821, 2), 6.48);
  EXPECT_DOUBLE_EQ(rejection_limit_to(13.5179, 2), 13.52);
  EXPECT_DOUBLE_EQ(acceptance_limit_to(10.0 - 0.3, 2), 9.7) << "a number as it is printed stays itself";
  EXPECT_DOUBLE_EQ(rejection_limit_to(10.0 + 0.1 + 0.2, 2), 10.3);
  EXPECT_DOUBLE_EQ(acceptance_limit_to(6487.77, -1), 6480);
  EXPECT_DOUBLE_EQ(rejection_limit_to(13512.2, -1), 13520);
}

TEST(Show, PartsCoordinatesByWhatIsNoDecimalMark) {
  EXPECT_EQ(shown_vector({0.5, -1, 2}, {}, 3), "(0.5, \u22121, 2)");
  Options comma;
  comma.numbers.decimal_mark = ',';
  EXPECT_EQ(shown_vector({0.5, -1, 2}, comma, 3), "(0,5; \u22121; 2)");
}

TEST(Show, HasNoMoreDigitsOfTheGuardBandThanOneBeyondThoseOfARoundedValue) {
  Reported table2 = reported_table2();  // 9600 ± 4300
  table2.options.unit = DisplayUnit::nm;
  EXPECT_EQ(limit_decimals(show(*iso230_2::find_parameter("A"), table2.assessment, AxisKind::linear, table2.options)),
            -1);
}

TEST(Show, SaysNotApplicableWhereAParameterDoesNotExist) {
  const Reported single =
      testing_support::reported({{}, testing_support::make_series({0, 100, 200}, {{1, 2, 3}}, {{2, 3, 4}}), {}});
  EXPECT_EQ(shown(single, "R").value, "not applicable");
  EXPECT_EQ(shown(single, "R").U, "");
  EXPECT_EQ(shown(single, "E").value, "3.0");
}

TEST(PositionDecimals, ShowEveryTargetFullyUpToATenthOfAMicrometre) {
  const auto decimals = [](std::vector<double> targets) {
    std::vector<Position> positions;
    for (double t : targets) positions.push_back(Position::native(t));
    return position_decimals(positions);
  };
  EXPECT_EQ(decimals({0, 100, 250}), 0);
  EXPECT_EQ(decimals({6.711, 175.077, 1055.89}), 3);
  EXPECT_EQ(decimals({0.1 + 0.2, 1}), 1);
  EXPECT_EQ(decimals({1.0 / 3.0, 1}), 4);
}

}  // namespace
}  // namespace axiometry::report
