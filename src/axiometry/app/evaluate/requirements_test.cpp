// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/requirements.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;
using Kind = uncertainty::DecisionRule::Kind;

constexpr std::string_view limits =
    "name,kind,travel_up_to,unit,rule,A,E,M\n"
    "Mill,linear,500,um,iso14253-1,30,20,10\n"
    "Mill,linear,2000,um,iso14253-1,33,22,11\n"
    "Grinder,linear,2000,um,,3,2,1\n";

Result<Requirements> demanded(const axiometry::Test& test, const ToleranceOptions& options) {
  return requirements_for(test, iso230_2::evaluate(test.series).parameters, options);
}

std::string refusal(const axiometry::Test& test, const ToleranceOptions& options) {
  const auto result = demanded(test, options);
  return result ? "" : result.error().message;
}

axiometry::Test table2_test() { return testing_support::table2::complete_test(); }

axiometry::Test single_run() { return {{}, testing_support::make_series({0, 100, 200}, {{1, 2, 3}}, {{2, 3, 4}}), {}}; }

TEST(Requirements, AreNoneWhenNobodyDemandsAnything) {
  const auto none = demanded(table2_test(), {});
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->tolerances.empty());
  EXPECT_EQ(none->rule.kind, Kind::simple);
}

TEST(Requirements, OfTheUserGoBeforeThoseOfTheTestAndThoseBeforeTheTable) {
  axiometry::Test test = table2_test();
  test.metadata.tolerance.E = Deviation::native(8);
  test.metadata.tolerance.B = Deviation::native(7);
  ToleranceOptions options{{*parse_tolerance("M=6um"), *parse_tolerance("B=5um")}, {}, {}, "Mill"};
  options.table = *read_tolerance_table(limits, "limits.csv");
  const auto all = demanded(test, options);
  ASSERT_TRUE(all) << all.error().message;
  std::string text;
  for (const auto& t : all->tolerances)
    text += std::string(t.parameter->key) + " " + std::to_string(static_cast<int>(t.limit.in_native())) + " " +
            std::string(iso230_2::tolerance_source_key(t.source)) + ", ";
  EXPECT_EQ(text, "A 33 table, E 8 test, M 6 user, B 5 user, ");
  EXPECT_EQ(all->rule.kind, Kind::iso_14253_1);
  EXPECT_EQ(all->band->name, "Mill");
  EXPECT_EQ(all->band->travel, "up to 2000 mm");
  EXPECT_THAT(all->tolerances.front().origin, HasSubstr("Mill, up to 2000 mm, in limits.csv, SHA-256 "));
  EXPECT_EQ(all->tolerances.back().origin, "");
}

TEST(Requirements, TakeTheRuleFromTheNearestToTheUser) {
  axiometry::Test test = table2_test();
  ToleranceOptions options{{}, {}, read_tolerance_table(limits, "limits.csv").value(), "Mill"};
  EXPECT_EQ(demanded(test, options)->rule.kind, Kind::iso_14253_1);
  test.metadata.tolerance.rule = "guard-band";
  test.metadata.tolerance.guard_band = Deviation::native(2);
  EXPECT_EQ(demanded(test, options)->rule.guard_band, 2.0);
  options.rule = *parse_rule("simple");
  EXPECT_EQ(demanded(test, options)->rule.kind, Kind::simple);
}

TEST(Requirements, TakeTheTableThatTheTestNamesUnlessTheUserNamesOne) {
  axiometry::Test test = table2_test();
  test.metadata.tolerance.table = "Grinder";
  ToleranceOptions options{{}, {}, read_tolerance_table(limits, "limits.csv").value(), ""};
  EXPECT_EQ(demanded(test, options)->band->name, "Grinder");
  options.table_name = "mill";
  EXPECT_EQ(demanded(test, options)->band->name, "Mill");
}

TEST(Requirements, RefuseALimitByHandOfWhatASingleTestDoesNotHave) {
  EXPECT_EQ(refusal(single_run(), {{*parse_tolerance("R=5um")}}),
            "found a tolerance of R for a test with a single approach to each target per direction (6.2), where R does "
            "not exist; expected one of E, E_up, E_down, M, B, B_mean");
  const axiometry::Test up_only{{}, testing_support::make_series({0, 100}, {{1, 2}, {1, 3}}, {}), {}};
  EXPECT_EQ(refusal(up_only, {{*parse_tolerance("A_up=5um"), *parse_tolerance("A_down=5um")}}),
            "found a tolerance of A_down for a test with approaches from below (↑) only (3.26), where A_down does not "
            "exist; expected one of A_up, E_up, R_up");
}

TEST(Requirements, TellOfALimitThatATestAmongManyOrATableCannotHold) {
  const auto told = [](const Result<Requirements>& all) {
    std::string text;
    for (const auto& finding : all.value().findings)
      if (finding.severity == iso230_2::Severity::missing) text += finding.message + "\n";
    return text;
  };
  EXPECT_EQ(
      told(demanded(single_run(), {{*parse_tolerance("R=5um")}, {}, {}, "", true})),
      "found a tolerance of R (of the command line) for a test with a single approach to each target per direction "
      "(6.2), where R does not exist: no verdict on it, and none that the test conforms\n");
  axiometry::Test test = single_run();
  test.metadata.tolerance.R = Deviation::native(5);
  const std::string of_both =
      told(demanded(test, {{}, {}, read_tolerance_table(limits, "limits.csv").value(), "Mill"}));
  EXPECT_THAT(of_both, HasSubstr("found a tolerance of R (of the test's file)"));
  EXPECT_THAT(of_both, HasSubstr("found a tolerance of A (of the tolerance table)"));
}

TEST(Requirements, KeepTheLimitsOfTheAxisThatNobodyReplaces) {
  axiometry::Test test = table2_test();
  test.metadata.tolerance.A = Deviation::native(12);
  ToleranceOptions options;
  for (const auto& [key, um] : {std::pair{"A", 10.0}, std::pair{"B", 5.0}})
    options.of_axis.push_back({iso230_2::find_parameter(key), Deviation::native(um), iso230_2::ToleranceSource::axis});
  const std::vector<std::pair<std::string, std::string>> entries = {{"tolerance.A", "12"}};
  const auto all = requirements_for(test, iso230_2::evaluate(test.series).parameters, options, entries);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->tolerances.size(), 2u);
  EXPECT_EQ(all->tolerances[0].limit.in_native(), 12.0);
  EXPECT_EQ(all->tolerances[0].source, iso230_2::ToleranceSource::entered);
  EXPECT_EQ(all->tolerances[0].replaced.front().limit.in_native(), 10.0);
  EXPECT_EQ(all->tolerances[1].parameter->key, "B");
  EXPECT_EQ(all->tolerances[1].source, iso230_2::ToleranceSource::axis);
  ASSERT_EQ(all->findings.size(), 1u);
  EXPECT_EQ(all->findings[0].message,
            "found two limits of A: 12 µm (entered for this test) takes the place of 10 µm (of the axis)");
}

std::string told_of(const axiometry::Test& test, const std::vector<std::pair<std::string, std::string>>& entries,
                    const Metadata& file, const ToleranceOptions& options = {}) {
  const auto all = requirements_for(test, iso230_2::evaluate(test.series).parameters, options, entries, &file);
  return all && !all->findings.empty() ? all->findings.front().message : "";
}

TEST(Requirements, TellOfALimitThatWasTakenAway) {
  axiometry::Test test = table2_test();
  Metadata file;
  file.tolerance.E = Deviation::native(5);
  EXPECT_EQ(told_of(test, {{"tolerance.E", ""}}, file),
            "the limit of E of the test's file, 5 µm, was taken away for this test");
}

TEST(Requirements, TellOfALimitOfTheFileThatAnEntryReplaces) {
  axiometry::Test test = table2_test();
  Metadata file;
  file.tolerance.E = Deviation::native(5);
  test.metadata.tolerance.E = Deviation::native(9);
  EXPECT_EQ(told_of(test, {{"tolerance.E", "9"}}, file),
            "found two limits of E: 9 µm (entered for this test) takes the place of 5 µm (of the test's file)");
}

TEST(Requirements, TellOfARuleThatAnotherReplaces) {
  axiometry::Test test = table2_test();
  test.metadata.tolerance.rule = "iso14253-1";
  EXPECT_EQ(
      told_of(test, {}, test.metadata, {{}, *parse_rule("simple")}),
      "found two decision rules: simple (of the command line) takes the place of iso14253-1 (of the test's file)");
  EXPECT_EQ(told_of(test, {}, test.metadata, {{}, *parse_rule("iso14253-1")}), "");
}

TEST(Requirements, DoNotMixLengthsAndAngles) {
  axiometry::Test test = table2_test();
  EXPECT_THAT(refusal(test, {{*parse_tolerance("A=10arcsec")}}), HasSubstr("for a linear axis"));
  EXPECT_THAT(refusal(test, {{}, *parse_rule("guard-band=3arcsec")}), HasSubstr("for a linear axis"));
}

}  // namespace
}  // namespace axiometry::app
