// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/tolerance_text.h"

#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

double limit_of(std::string_view text, AxisKind kind) {
  const auto parsed = parse_tolerance(text);
  EXPECT_TRUE(parsed) << text;
  const auto tolerances = tolerances_for(kind, {*parsed});
  EXPECT_TRUE(tolerances) << text;
  return tolerances->front().limit.in_native();
}

std::string refusal_of_text(std::string_view text) {
  const auto parsed = parse_tolerance(text);
  return parsed ? "" : parsed.error().message;
}

TEST(ToleranceText, ConvertsEveryUnitToTheAxisUnit) {
  EXPECT_EQ(limit_of("A=10um", AxisKind::linear), 10.0);
  EXPECT_EQ(limit_of("A = 10 µm", AxisKind::linear), 10.0);
  EXPECT_EQ(limit_of("R_up=0.003mm", AxisKind::linear), 3.0);
  EXPECT_EQ(limit_of("B=250nm", AxisKind::linear), 0.25);
  EXPECT_EQ(limit_of("A↑=8arcsec", AxisKind::rotary), 8.0);
  EXPECT_EQ(limit_of("E=0.01deg", AxisKind::rotary), 36.0);
}

TEST(ToleranceText, RefusesWhatItCannotRead) {
  EXPECT_EQ(refusal_of_text("A"), "found the tolerance \"A\", expected PARAMETER=LIMIT such as A=10um");
  EXPECT_EQ(
      refusal_of_text("Q=1um"),
      "found the tolerance \"Q=1um\", expected one of the parameters A, A_up, A_down, E, E_up, E_down, M, R, R_up, "
      "R_down, B, B_mean");
  EXPECT_EQ(refusal_of_text("A=10"),
            "found the tolerance \"A=10\", expected a limit with its unit um, mm, nm, arcsec or deg");
  EXPECT_EQ(refusal_of_text("A=-1um"),
            "found the tolerance \"A=-1um\", expected a limit that is a number above 0, with a decimal point");
  EXPECT_EQ(refusal_of_text("A=ten um"),
            "found the tolerance \"A=ten um\", expected a limit that is a number above 0, with a decimal point");
}

TEST(ToleranceText, RefusesALimitThatNothingCouldKeepOrNothingCouldExceed) {
  EXPECT_EQ(refusal_of_text("A=0um"),
            "found the tolerance \"A=0um\", expected a limit that is a number above 0, with a decimal point");
  EXPECT_EQ(refusal_of_text("A=1e400um"),
            "found the tolerance \"A=1e400um\", expected a limit that is a number above 0, with a decimal point");
  EXPECT_EQ(refusal_of_text("A=nanum"),
            "found the tolerance \"A=nanum\", expected a limit that is a number above 0, with a decimal point");
  EXPECT_EQ(refusal_of_text("A=1001mm"), "found the tolerance \"A=1001mm\", expected a limit of at most 1e+06 um");
}

TEST(ToleranceText, HasOneLimitPerParameterAndKindOfAxis) {
  const auto checked = [](std::vector<std::string_view> texts) {
    std::vector<ToleranceText> all;
    for (std::string_view text : texts) all.push_back(*parse_tolerance(text));
    const auto result = check_tolerances(all);
    return result ? std::string() : result.error().message;
  };
  EXPECT_EQ(checked({"A=10um", "E=10um", "A=5arcsec"}), "");
  EXPECT_EQ(checked({"A=10um", "E=10um", "A=0.01mm"}),
            "found the tolerances A=10um and A=0.01mm, expected one limit of A");
}

TEST(ToleranceText, TakesTheLimitForTheKindOfTheAxis) {
  const std::vector<ToleranceText> both = {*parse_tolerance("A=10um"), *parse_tolerance("A=5arcsec")};
  EXPECT_EQ(tolerances_for(AxisKind::linear, both)->at(0).limit.in_native(), 10.0);
  EXPECT_EQ(tolerances_for(AxisKind::rotary, both)->at(0).limit.in_native(), 5.0);
  EXPECT_EQ(tolerances_for(AxisKind::rotary, both)->size(), 1u);
}

using Kind = uncertainty::DecisionRule::Kind;

TEST(RuleText, KnowsTheThreeRules) {
  EXPECT_EQ(rule_for(AxisKind::linear, *parse_rule("simple"))->kind, Kind::simple);
  EXPECT_EQ(rule_for(AxisKind::linear, *parse_rule("iso14253-1"))->kind, Kind::iso_14253_1);
  const auto guarded = rule_for(AxisKind::linear, *parse_rule("guard-band = 0.003 mm"));
  EXPECT_EQ(guarded->kind, Kind::guard_band);
  EXPECT_EQ(guarded->guard_band, 3.0);
}

TEST(RuleText, RefusesWhatItCannotRead) {
  const auto refused = [](std::string_view text) {
    const auto rule = parse_rule(text);
    return rule ? std::string() : rule.error().message;
  };
  EXPECT_EQ(refused("strict"),
            "found the rule \"strict\", expected simple, iso14253-1 or guard-band=WIDTH such as guard-band=3um");
  EXPECT_EQ(refused("simple=3um"),
            "found the rule \"simple=3um\", expected simple, iso14253-1 or guard-band=WIDTH such as guard-band=3um");
  for (std::string_view text : {"guard-band=3", "guard-band=-3um", "guard-band=um", "guard-band="})
    EXPECT_NE(refused(text).find("expected a width that is a number, 0 or more, with its unit"), std::string::npos)
        << text;
  EXPECT_EQ(rule_for(AxisKind::rotary, *parse_rule("guard-band=3um")).error().message,
            "found the rule guard-band=3um for a rotary axis, expected a width in arcsec or deg");
}

TEST(StatedRule, NeedsAWidthForAGuardBandAndForNothingElse) {
  Metadata m;
  EXPECT_FALSE(*stated_rule(m));
  m.tolerance.rule = "iso14253-1";
  EXPECT_EQ((*stated_rule(m))->kind, Kind::iso_14253_1);
  m.tolerance.guard_band = Deviation::native(2);
  EXPECT_EQ(stated_rule(m).error().message,
            "found tolerance.guard_band with tolerance.rule = iso14253-1, expected tolerance.rule = guard-band");
  m.tolerance.rule = "guard-band";
  EXPECT_EQ((*stated_rule(m))->guard_band, 2.0);
  m.tolerance.guard_band.reset();
  EXPECT_EQ(stated_rule(m).error().message,
            "found tolerance.rule = guard-band alone, expected its width in tolerance.guard_band, in µm");
}

TEST(ToleranceText, DoesNotMixLengthsAndAngles) {
  const auto result = tolerances_for(AxisKind::rotary, {*parse_tolerance("A=10um")});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "found the tolerance A=10um for a rotary axis, expected a limit in arcsec or deg");
}

}  // namespace
}  // namespace axiometry::app
