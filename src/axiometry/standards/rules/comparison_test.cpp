// SPDX-License-Identifier: Apache-2.0
//
// Figures of Table 2 computed by another program (tests/rules_oracle.py); small ones by hand.
#include "axiometry/standards/rules/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "tests/support/series.h"

namespace axiometry::standards {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::make_series;
using testing_support::none;
using testing_support::RunDeviations;

axiometry::Test test_of(Series series, AxisKind kind = AxisKind::linear) {
  Metadata metadata;
  metadata.axis.kind = kind;
  return {metadata, std::move(series), {}};
}

RuleComparison compared(const axiometry::Test& test) { return compare_rules(test, {}).value(); }

const ComparedFigure& figure(const RuleComparison& comparison, std::string_view rule, std::string_view key) {
  for (const ComparedRule& each : comparison.rules)
    for (const ComparedFigure& found : each.figures)
      if (each.rule->id == rule && found.figure->key == key) return found;
  throw std::logic_error("no such figure");
}

double value(const RuleComparison& comparison, std::string_view rule, std::string_view key) {
  return figure(comparison, rule, key).value.value().in_native();
}

std::string_view absence(const RuleComparison& comparison, std::string_view rule, std::string_view key) {
  const ComparedFigure& found = figure(comparison, rule, key);
  EXPECT_EQ(found.value.has_value(), found.absence.empty());
  return found.absence;
}

std::vector<std::string> messages(const std::vector<iso230_2::Finding>& findings, std::string_view clause) {
  std::vector<std::string> all;
  for (const auto& finding : findings)
    if (finding.clause == clause) all.push_back(finding.message);
  return all;
}

/// So many runs of both directions, at 11 targets.
RuleComparison of_runs(std::size_t runs) {
  const std::vector<double> targets{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  std::vector<RunDeviations> up, down;
  for (std::size_t j = 0; j < runs; ++j) {
    up.push_back(RunDeviations(targets.size(), static_cast<double>(j)));
    down.push_back(RunDeviations(targets.size(), 1.0 + 2.0 * static_cast<double>(j)));
  }
  return compared(test_of(make_series(targets, up, down)));
}

TEST(CompareRules, GivesTheFiguresOfTable2) {
  const RuleComparison c = compared(testing_support::table2::complete_test());
  EXPECT_NEAR(value(c, "vdi-dgq-3441", "P"), 10.626681494529517, 1e-9);
  EXPECT_NEAR(value(c, "vdi-dgq-3441", "P_a"), 3.99, 1e-9);
  EXPECT_NEAR(value(c, "vdi-dgq-3441", "P_s_max"), 3.9768244777056196, 1e-9);
  EXPECT_NEAR(value(c, "vdi-dgq-3441", "P_s_mean"), 2.8262099224778754, 1e-9);
  EXPECT_NEAR(value(c, "vdi-dgq-3441", "U_mean"), 3.710909090909091, 1e-9);
  EXPECT_NEAR(value(c, "jis-b-0182-1993", "A"), 10.619596331260167, 1e-9);
  EXPECT_NEAR(value(c, "jis-b-0182-1993", "R"), 7.87682447770562, 1e-9);
  EXPECT_NEAR(value(c, "gb-t-38614-2020", "repeatability"), 2.412856191321812, 1e-9);
  EXPECT_NEAR(value(c, "gb-t-38614-2020", "linearity_up"), 1.1234044389608056, 1e-9);
  EXPECT_NEAR(value(c, "export-lists", "2B001"), 2.5518620652378528, 1e-9);
}

TEST(CompareRules, GivesOlderEditionsTheFiguresOf2014) {
  const RuleComparison c = compared(testing_support::table2::complete_test());
  for (const std::string_view rule : {"iso-230-2-1997", "iso-230-2-2006", "gb-t-17421-2-2000", "jis-b-6190-2"})
    for (const auto& parameter : iso230_2::parameters)
      EXPECT_EQ(value(c, rule, parameter.key), (c.iso230_2.evaluation.parameters.*parameter.member).value().in_native())
          << rule << " " << parameter.key;
}

TEST(CompareRules, GivesOneValueWhereverNoDifferenceOfTheFormulaIsTold) {
  const RuleComparison c = of_runs(10);
  for (const ComparedRule& rule : c.rules)
    for (const ComparedFigure& each : rule.figures) {
      if (!each.figure->departs_by.empty() || !each.counterpart) continue;
      EXPECT_NEAR(each.difference().value().in_native(), 0.0, 1e-12) << rule.rule->id << " " << each.figure->key;
    }
}

TEST(CompareRules, WarnsOfEachFigureThatIsAnotherAndSaysHowFarItIsKnown) {
  const auto warnings = compared(testing_support::table2::complete_test()).warnings;
  EXPECT_THAT(
      messages(warnings, "VDI/DGQ 3441"),
      Contains("for this axis P after VDI/DGQ 3441 is 10.6 µm, but A after ISO 230-2:2014 is 9.59 µm: they are not the "
               "same figure (second-hand, not checked against the text of the rule)"));
  EXPECT_THAT(messages(warnings, "JIS B 0182:1993"), Contains(HasSubstr("(read in the text of the rule)")));
  EXPECT_THAT(messages(warnings, "ISO 230-2:2006"), ::testing::IsEmpty());
}

TEST(CompareRules, SaysThatTwoFiguresLookEqualInsteadOfThatTheyDiffer) {
  const RuleComparison c = compared(test_of(make_series({0, 1}, {{1, 3}, {1, 3}}, {{1, 3}, {1, 3}})));
  EXPECT_THAT(messages(c.warnings, "VDI/DGQ 3441"),
              Contains(HasSubstr(
                  "P after VDI/DGQ 3441 and A after ISO 230-2:2014 are both 2 µm, and yet not the same figure")));
}

TEST(CompareRules, WarnsOfNothingThatHasNoValue) {
  const RuleComparison c = compared(test_of(make_series({0, 1}, {{1, 3}}, {})));
  for (const auto& warning : c.warnings) EXPECT_THAT(warning.message, Not(HasSubstr("VDI")));
}

TEST(CompareRules, TakesTheReversalIntoHalfTheBandOfEachTarget) {
  // x̄↑ = 0, x̄↓ = −4, s = 1 in both: half width (4 + 6)/2 at both targets, x̿ = −2.
  const RuleComparison c =
      compared(test_of(make_series({0, 1}, {{1, 1}, {-1, -1}, {0, 0}}, {{-3, -3}, {-5, -5}, {-4, -4}})));
  EXPECT_DOUBLE_EQ(value(c, "vdi-dgq-3441", "P"), 10.0);
  EXPECT_DOUBLE_EQ(value(c, "vdi-dgq-3441", "P_s_max"), 6.0);
  EXPECT_DOUBLE_EQ(value(c, "vdi-dgq-3441", "U_max"), 4.0);
  EXPECT_DOUBLE_EQ(value(c, "jis-b-0182-1993", "R"), 10.0);
  EXPECT_DOUBLE_EQ(value(c, "jis-b-0182-1993", "A"), 10.0);
}

TEST(CompareRules, RefusesWhatAnotherDirectionWouldHaveToGive) {
  const RuleComparison c = compared(test_of(make_series({0, 1}, {{1, 3}, {2, 3}}, {})));
  EXPECT_EQ(absence(c, "vdi-dgq-3441", "P"), "needs approaches from both directions");
  EXPECT_EQ(absence(c, "iso-230-2-2006", "A"), "needs approaches from both directions");
  EXPECT_EQ(absence(c, "iso-230-2-2006", "R_down"), "needs approaches from this direction");
  EXPECT_EQ(absence(c, "iso-230-2-2006", "R_up"), "");
  EXPECT_EQ(absence(c, "jis-b-6201", "positioning_up"), "");
}

TEST(CompareRules, RefusesWhatOneApproachCannotGive) {
  const RuleComparison c = compared(test_of(make_series({0, 1}, {{1, 3}}, {{1, 2}})));
  EXPECT_EQ(absence(c, "vdi-dgq-3441", "P"), "needs two approaches or more to every target from each direction");
  EXPECT_EQ(absence(c, "gb-t-38614-2020", "repeatability_up"), "needs two approaches or more to every target");
  EXPECT_DOUBLE_EQ(value(c, "vdi-dgq-3441", "U_max"), 1.0);
}

TEST(CompareRules, LetsNoLowerBoundStandForAMissingReadingInRulesThatHaveNone) {
  // Target 2 was reached once from below.
  const RuleComparison c = compared(test_of(make_series({0, 1}, {{0, 9}, {0, none}}, {{0, 0}, {0, 2}})));
  for (const auto& [rule, key] :
       {std::pair{"vdi-dgq-3441", "P"}, std::pair{"jis-b-0182-1993", "A"}, std::pair{"export-lists", "2B001"},
        std::pair{"export-lists", "2B201"}, std::pair{"gb-t-38614-2020", "repeatability"}})
    EXPECT_NE(absence(c, rule, key), "") << rule << " " << key;
}

TEST(CompareRules, GivesNoRepeatabilityOfSevenApproachesWithSix) {
  EXPECT_EQ(absence(of_runs(6), "jis-b-6201", "repeatability_up"),
            "needs seven approaches to both ends and the middle from this direction");
  EXPECT_EQ(absence(of_runs(6), "jis-b-6201", "lost_motion"),
            "needs seven approaches to both ends and the middle from each direction");
  EXPECT_TRUE(messages(of_runs(6).findings, "JIS B 6201, JIS B 6330").empty());
}

TEST(CompareRules, TakesTheFirstSevenOfMoreApproaches) {
  for (const std::size_t runs : {7u, 9u}) {
    const RuleComparison c = of_runs(runs);
    EXPECT_DOUBLE_EQ(value(c, "jis-b-6201", "repeatability_up"), 3.0);
    EXPECT_DOUBLE_EQ(value(c, "jis-b-6201", "repeatability_down"), 6.0);
    EXPECT_DOUBLE_EQ(value(c, "jis-b-6201", "lost_motion"), 4.0);  // 3 and 1 + 6
    EXPECT_THAT(messages(c.findings, "JIS B 6201, JIS B 6330"), Contains(HasSubstr("a drift between the runs")));
  }
}

// A reading is missing at a target that the rule does not look at.
TEST(CompareRules, TellsOfADriftBetweenRunsWhereverItGivesARepeatability) {
  std::vector<RunDeviations> up(7, {0, 1, 2, 3, 4});
  up[3][1] = none;
  const RuleComparison c = compared(test_of(make_series({0, 1, 2, 3, 4}, up, {})));
  EXPECT_DOUBLE_EQ(value(c, "jis-b-6201", "repeatability_up"), 0.0);
  EXPECT_THAT(messages(c.findings, "JIS B 6201, JIS B 6330"), Contains(HasSubstr("a drift between the runs")));
}

TEST(CompareRules, SaysNothingOfADriftBetweenRunsWhereApproachesFollowOneAnother) {
  axiometry::Test test = test_of(make_series({0, 1}, std::vector<RunDeviations>(7, {1, 2}), {}));
  test.metadata.conditions.cycle = TestCycle::step;
  const RuleComparison c = compared(test);
  EXPECT_TRUE(messages(c.findings, "JIS B 6201, JIS B 6330").empty());
  EXPECT_FALSE(c.iso230_2.label.empty());
}

TEST(CompareRules, DropsTheFirstRunOfBidirectionalRepeatabilityOfPiezoStages) {
  // Without the first run ↑ 0, 2 and ↓ 4, 6, about 3: √((9 + 1)/1).
  const RuleComparison c =
      compared(test_of(make_series({0, 1}, {{99, 99}, {0, 0}, {2, 2}}, {{-99, -99}, {4, 4}, {6, 6}})));
  EXPECT_DOUBLE_EQ(value(c, "gb-t-38614-2020", "repeatability"), std::sqrt(10.0));
  EXPECT_EQ(absence(of_runs(2), "gb-t-38614-2020", "repeatability"),
            "needs three runs or more, of which the first is dropped");
}

TEST(CompareRules, StatesHysteresisAsAPartOfTheTravelInItsUnits) {
  const auto share = [](AxisKind kind) {
    const RuleComparison c = compared(test_of(make_series({0, 100}, {{1, 5}}, {{1, 1}}), kind));
    return figure(c, "gb-t-38614-2020", "hysteresis").share_of_travel.value();
  };
  EXPECT_DOUBLE_EQ(share(AxisKind::linear), 4.0 / 100'000.0);
  EXPECT_DOUBLE_EQ(share(AxisKind::rotary), 4.0 / 360'000.0);
}

TEST(CompareRules, TellsHowManyApproachesEachRuleAsksFor) {
  const auto said = [](std::size_t runs, std::string_view rule) {
    std::string all;
    for (const auto& message : messages(of_runs(runs).findings, rule)) all += message + "\n";
    return all;
  };
  EXPECT_THAT(said(4, "VDI/DGQ 3441"),
              HasSubstr("found 4 approaches to a target from one direction, expected 5 or more for all figures"));
  EXPECT_EQ(said(5, "VDI/DGQ 3441"), "");
  EXPECT_THAT(said(1, "VDI/DGQ 3441"), HasSubstr("found 1 approach to"));
  EXPECT_THAT(said(5, "GB/T 38614-2020"), HasSubstr("10 or more for unidirectional repeatability"));
  EXPECT_THAT(said(5, "GB/T 38614-2020"), HasSubstr("6 or more for bidirectional repeatability"));
  EXPECT_THAT(said(5, "GB/T 38614-2020"), Not(HasSubstr("for accuracy")));
  EXPECT_THAT(said(10, "GB/T 38614-2020"), Not(HasSubstr("approach")));
}

TEST(CompareRules, TellsWhatAPiezoStageAsksOfTargetsAndTravel) {
  const std::vector<RunDeviations> runs(10, RunDeviations(3, 1.0));
  axiometry::Test test = test_of(make_series({0, 1, 3}, runs, runs));
  const auto said = [&] {
    std::string all;
    for (const auto& message : messages(compared(test).findings, "GB/T 38614-2020")) all += message + "\n";
    return all;
  };
  EXPECT_THAT(said(), HasSubstr("found 3 targets, expected 11"));
  EXPECT_THAT(said(), HasSubstr("unequal steps"));
  EXPECT_THAT(said(), HasSubstr("travel of the axis is not stated"));
  test.metadata.axis.travel_begin = Position::native(0);
  test.metadata.axis.travel_end = Position::native(4);
  EXPECT_THAT(said(), HasSubstr("found no target at one end"));
  test.metadata.axis.travel_end = Position::native(3);
  EXPECT_THAT(said(), Not(HasSubstr("travel")));
}

TEST(CompareRules, GivesListsOfExportControlNoRotaryAxis) {
  const RuleComparison c = compared(test_of(make_series({0, 1}, {{1, 3}, {2, 3}}, {{1, 1}, {2, 4}}), AxisKind::rotary));
  EXPECT_EQ(absence(c, "export-lists", "2B001"), "is of linear axes alone");
  EXPECT_EQ(absence(c, "vdi-dgq-3441", "P"), "");
}

TEST(CompareRules, KeepsTheDeparturesFromTheEditionBesideWhichFiguresStand) {
  const RuleComparison c = compared(test_of(make_series({0, 1}, {{1, 3}}, {{1, 2}})));
  EXPECT_FALSE(c.iso230_2.conforming());
  EXPECT_THAT(c.findings, Contains(::testing::Field(&iso230_2::Finding::clause, HasSubstr("ISO 230-2:2014, 5.3"))));
  EXPECT_THAT(c.findings, Contains(::testing::Field(&iso230_2::Finding::id, "number-of-approaches")));
  EXPECT_THAT(c.findings, Contains(::testing::Field(&iso230_2::Finding::id, "vdi-dgq-3441-number-of-approaches")));
  EXPECT_THAT(compared(testing_support::table2::complete_test()).warnings,
              Contains(::testing::Field(&iso230_2::Finding::id, "not-the-same-figure")));
}

TEST(CompareRules, RefusesADiagonal) {
  axiometry::Test test = testing_support::table2::complete_test();
  test.metadata.axis.line_origin_mm = {0, 0, 0};
  test.metadata.axis.line_direction = {1, 1, 0};
  const auto refused = compare_rules(test, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("found a diagonal"));
}

TEST(CompareRules, TakesOnlyTheRulesThatAreNamed) {
  const AxisRule* rule = find_axis_rule("vdi-dgq-3441");
  const RuleComparison c = compare_rules(testing_support::table2::complete_test(), std::span(&rule, 1)).value();
  ASSERT_EQ(c.rules.size(), 1u);
  for (const auto& warning : c.warnings) EXPECT_EQ(warning.clause, "VDI/DGQ 3441");
}

TEST(AxisRules, AreNamedOnceAndHaveFiguresOfOneKeyEach) {
  std::set<std::string_view> ids, names;
  for (const AxisRule* rule : axis_rule_table()) {
    EXPECT_TRUE(ids.insert(rule->id).second && names.insert(rule->name).second);
    EXPECT_EQ(find_axis_rule(rule->id), rule);
    std::set<std::string_view> keys;
    for (const RuleFigure& each : rule->figures) EXPECT_TRUE(keys.insert(each.key).second) << rule->id;
    EXPECT_FALSE(keys.empty()) << rule->id;
  }
  EXPECT_EQ(ids.size(), 9u);
  EXPECT_EQ(find_axis_rule("nmtba"), nullptr);
}

TEST(AxisRules, SayOfEveryFigureThatWasNotReadInItsRuleThatItWasNotChecked) {
  for (const Evidence evidence : {Evidence::makers_text, Evidence::program, Evidence::second_hand})
    EXPECT_THAT(evidence_words(evidence), HasSubstr("not checked against the text of the rule"));
  EXPECT_THAT(evidence_words(Evidence::text), Not(HasSubstr("not checked")));
}

}  // namespace
}  // namespace axiometry::standards
