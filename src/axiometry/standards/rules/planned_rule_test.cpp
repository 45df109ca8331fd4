// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/planned_rule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "axiometry/language/language.h"

namespace axiometry::standards {
namespace {

using testing::Contains;
using testing::HasSubstr;

iso230_2::PlanRequest over_half_a_metre() {
  iso230_2::PlanRequest request;
  request.axis.name = "X";
  request.axis.travel_begin = Position::native(0.0);
  request.axis.travel_end = Position::native(500.0);
  request.seed = 7;
  return request;
}

Plan planned_by(const AxisRule& rule, iso230_2::PlanRequest request = over_half_a_metre()) {
  auto with = with_cycle_of(rule, std::move(request));
  EXPECT_TRUE(with) << rule.id;
  auto plan = iso230_2::make_plan(*with);
  EXPECT_TRUE(plan) << rule.id << ": " << plan.error().message;
  return *std::move(plan);
}

std::vector<std::string> ids_of_rule(const AxisRule& rule, const Plan& plan) {
  std::vector<std::string> ids;
  for (const iso230_2::Finding& finding : planned_rule_findings(rule, plan)) {
    EXPECT_EQ(finding.severity, iso230_2::Severity::note) << finding.id << ": ISO 230-2 is another question";
    ids.push_back(finding.id);
  }
  return ids;
}

/// Beside what is said of every plan: ends that nobody can approach from beyond.
bool is_left(const std::string& id) { return id == "plan-rule" || id == "gb-t-38614-2020-ends-of-travel"; }

TEST(PlannedRule, LeavesNothingOfItsCycleToBeFoundOfTheTest) {
  for (const AxisRule* rule : axis_rule_table()) {
    const Plan plan = planned_by(*rule);
    EXPECT_EQ(plan.rule, rule->id);
    for (const std::string& id : ids_of_rule(*rule, plan)) EXPECT_TRUE(is_left(id)) << rule->id << ": " << id;
  }
}

TEST(PlannedRule, AsksForItsApproachesTargetsAndSteps) {
  EXPECT_EQ(planned_by(*find_axis_rule("vdi-dgq-3441")).runs, 5u);
  EXPECT_EQ(planned_by(*find_axis_rule("jis-b-6201")).runs, 7u);
  EXPECT_EQ(planned_by(*find_axis_rule("jis-b-6201")).cycle, TestCycle::step);
  const Plan piezo = planned_by(*find_axis_rule("gb-t-38614-2020"));
  EXPECT_EQ(piezo.runs, 10u);
  ASSERT_EQ(piezo.targets.size(), 11u);
  const double step = (piezo.targets.back().in_native() - piezo.targets.front().in_native()) / 10.0;
  for (std::size_t i = 1; i < piezo.targets.size(); ++i)
    EXPECT_NEAR(piezo.targets[i].in_native() - piezo.targets[i - 1].in_native(), step, 2e-3);
  // A long axis has one run after ISO 230-2.
  iso230_2::PlanRequest axis = over_half_a_metre();
  axis.axis.travel_end = Position::native(4000.0);
  EXPECT_EQ(iso230_2::make_plan(axis)->runs, 1u);
  EXPECT_EQ(planned_by(*find_axis_rule("vdi-dgq-3441"), axis).runs, 5u);
  const Plan with_area = planned_by(*find_axis_rule("jis-b-6201"), axis);
  ASSERT_EQ(with_area.further.size(), 1u);
  EXPECT_EQ(with_area.further[0].cycle, TestCycle::step);
  EXPECT_EQ(with_area.further[0].runs, 7u) << "the step cycle of five runs is no test of either rule";
  const Plan piezo_area = planned_by(*find_axis_rule("gb-t-38614-2020"), axis);
  EXPECT_EQ(piezo_area.further.at(0).runs, 10u);
  EXPECT_EQ(piezo_area.further.at(0).targets.size(), 11u);
  // Runs that a user asks for are those of the whole travel.
  axis.runs = 3;
  const Plan of_three = planned_by(*find_axis_rule("jis-b-6201"), axis);
  EXPECT_EQ(of_three.runs, 3u);
  EXPECT_EQ(of_three.further.at(0).runs, 7u);
}

TEST(PlannedRule, JudgesTheTestsThatBelongToALongOneAndNamesThem) {
  iso230_2::PlanRequest request = over_half_a_metre();
  request.axis.travel_end = Position::native(4000.0);
  for (const AxisRule* rule : axis_rule_table())
    for (const std::string& id : ids_of_rule(*rule, planned_by(*rule, request)))
      EXPECT_TRUE(is_left(id)) << rule->id << ": " << id;
  const AxisRule& rule = *find_axis_rule("vdi-dgq-3441");
  Plan plan = planned_by(rule, request);
  EXPECT_THAT(planned_rule_findings(rule, plan).front().message, HasSubstr("keeps to what is known"));
  plan.further.at(0).runs = 1;
  const auto findings = planned_rule_findings(rule, plan);
  EXPECT_THAT(findings.front().message, HasSubstr("departs from what is known"));
  EXPECT_EQ(findings.back().id, "vdi-dgq-3441-number-of-approaches");
  EXPECT_EQ(findings.back().message,
            "Normal working area, 1000 to 3000 mm: by VDI/DGQ 3441: found 1 approach to a target from one direction, "
            "expected 5 or more for all figures");
  for (const language::Language language : language::languages())
    EXPECT_TRUE(language::is_known(findings.back().message, language));
}

TEST(PlannedRule, GivesWayToWhatIsAskedForAndSaysSo) {
  iso230_2::PlanRequest request = over_half_a_metre();
  request.runs = 3;
  const AxisRule& rule = *find_axis_rule("vdi-dgq-3441");
  const Plan plan = planned_by(rule, request);
  EXPECT_EQ(plan.runs, 3u);
  EXPECT_THAT(ids_of_rule(rule, plan), testing::ElementsAre("plan-rule", "vdi-dgq-3441-number-of-approaches"));
  EXPECT_THAT(planned_rule_findings(rule, plan).front().message, HasSubstr("departs from what is known"));
  EXPECT_THAT(planned_rule_findings(rule, plan).back().message,
              HasSubstr("by VDI/DGQ 3441: found 3 approaches to a target from one direction, expected 5 or more"));
  const AxisRule& piezo = *find_axis_rule("gb-t-38614-2020");
  EXPECT_THAT(ids_of_rule(piezo, planned_by(rule)), Contains("gb-t-38614-2020-approaches-for-repeatability"));
}

/// Of a test it is its figures that are absent; of a plan nothing else says so.
TEST(PlannedRule, KeepsToNoCycleWithFewerApproachesOneDirectionOrAnotherOrder) {
  const auto judged = [](const char* id, auto change) {
    iso230_2::PlanRequest request = over_half_a_metre();
    change(request);
    const AxisRule& rule = *find_axis_rule(id);
    // The order of the rule takes the place of the standard cycle, so that it is changed in the plan.
    Plan plan = planned_by(rule, request);
    if (request.cycle == TestCycle::standard && request.runs == 7u) plan.cycle = TestCycle::standard;
    return planned_rule_findings(rule, plan);
  };
  const auto few = judged("jis-b-6201", [](auto& request) { request.runs = 3; });
  EXPECT_THAT(few.front().message, HasSubstr("departs from what is known"));
  EXPECT_EQ(few.back().message,
            "by JIS B 6201, JIS B 6330: found 3 approaches to a target from one direction, expected 7 or more for all "
            "figures");
  const auto reordered = judged("jis-b-6201", [](auto& request) { request.runs = 7; });
  EXPECT_THAT(reordered.front().message, HasSubstr("departs from what is known"));
  EXPECT_EQ(reordered.at(1).id, "plan-rule-order");
  EXPECT_EQ(reordered.at(1).message,
            "by JIS B 6201, JIS B 6330: found the order of the standard cycle, expected that of the step cycle");
  for (const language::Language language : language::languages())
    EXPECT_TRUE(language::is_known(reordered.at(1).message, language));
  const auto one_way = judged("vdi-dgq-3441", [](auto& request) { request.cycle = TestCycle::unidirectional; });
  EXPECT_THAT(one_way.front().message, HasSubstr("departs from what is known"));
  EXPECT_EQ(one_way.back().message,
            "by VDI/DGQ 3441: found approaches from one direction only, expected both for all figures");
  EXPECT_THAT(judged("vdi-dgq-3441", [](auto&) {}).front().message, HasSubstr("keeps to what is known"));
}

/// Made by one rule and judged by another: only what both do not share is found.
TEST(PlannedRule, TellsWhatAnotherRuleAsksForBeyondIt) {
  using Ids = std::vector<std::string>;
  const Ids by_piezo = {"plan-rule",
                        "gb-t-38614-2020-number-of-targets",
                        "gb-t-38614-2020-equal-steps",
                        "gb-t-38614-2020-ends-of-travel",
                        "gb-t-38614-2020-approaches-for-repeatability"};
  for (const AxisRule* made_by : axis_rule_table()) {
    const Plan plan = planned_by(*made_by);
    for (const AxisRule* judge : axis_rule_table()) {
      if (judge == made_by) continue;
      Ids expected = {"plan-rule"};
      const bool of_piezo = made_by->id == "gb-t-38614-2020";
      if (judge->id == "jis-b-6201") expected.emplace_back("plan-rule-order");
      if (judge->id == "jis-b-6201" && of_piezo) expected.emplace_back("jis-b-6201-runs-for-approaches");
      if (judge->id == "jis-b-6201" && !of_piezo) expected.emplace_back("plan-rule-approaches");
      if (judge->id == "gb-t-38614-2020") expected = by_piezo;
      if (judge->id == "gb-t-38614-2020" && plan.runs < 6)
        expected.emplace_back("gb-t-38614-2020-approaches-for-both");
      EXPECT_EQ(ids_of_rule(*judge, plan), expected) << made_by->id << " by " << judge->id;
    }
  }
}

TEST(PlannedRule, SaysOnWhatItRestsAndWhereNothingIsKnown) {
  const auto first = [](const char* id) {
    const AxisRule& rule = *find_axis_rule(id);
    return planned_rule_findings(rule, planned_by(rule)).front().message;
  };
  EXPECT_THAT(first("vdi-dgq-3441"), HasSubstr("second-hand, not checked against the text of the rule"));
  EXPECT_THAT(first("iso-230-2-2006"), HasSubstr("nothing is known of the cycle that ISO 230-2:2006 asks for"));
}

TEST(PlannedRule, IsOfPositionsOverTheTravel) {
  iso230_2::PlanRequest request = over_half_a_metre();
  request.periodic.emplace();
  EXPECT_FALSE(with_cycle_of(*find_axis_rule("vdi-dgq-3441"), request));
  request = over_half_a_metre();
  request.errors.push_back(*motion_name("EYX"));
  EXPECT_FALSE(with_cycle_of(*find_axis_rule("vdi-dgq-3441"), request));
  for (const AxisRule* rule : axis_rule_table()) {
    iso230_2::PlanRequest turning = over_half_a_metre();
    turning.axis.kind = AxisKind::rotary;
    EXPECT_EQ(with_cycle_of(*rule, turning).has_value(), !rule->linear_only) << rule->id;
  }
}

}  // namespace
}  // namespace axiometry::standards
