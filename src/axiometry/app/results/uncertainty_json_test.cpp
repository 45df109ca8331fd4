// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/uncertainty_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/app/results/result_json.h"
#include "tests/support/made_up_monte_carlo.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Evaluated evaluated() {
  Test test = testing_support::table2::complete_test();
  auto assessment = iso230_2::assess(test);
  assessment.gum = iso230_2::gum(test, assessment.evaluation).value();
  assessment.monte_carlo = testing_support::made_up_monte_carlo(assessment.evaluation);
  return {std::move(test), "", std::move(assessment), {}, {}};
}

/// The value at a path such as "gum.A.u".
const json::Value& at(const json::Value& root, std::string_view path) {
  const json::Value* value = &root;
  while (!path.empty()) {
    const std::string_view name = path.substr(0, path.find('.'));
    value = value->find(name);
    if (value == nullptr) throw std::logic_error("no member " + std::string(name));
    path.remove_prefix(std::min(path.size(), name.size() + 1));
  }
  return *value;
}

TEST(UncertaintyWire, KeepsTheMethodsApart) {
  const Evaluated e = evaluated();
  const json::Value object = uncertainty_to_json(e.assessment);
  EXPECT_EQ(at(object, "annex_a.A").number(), e.assessment.annex_a->U.A->in_native());
  EXPECT_EQ(at(object, "gum.A.U").number(), e.assessment.gum->find("A")->uncertainty.U.in_native());
  EXPECT_EQ(at(object, "monte_carlo.A.u").number(), e.assessment.monte_carlo->distributions[0]->summary.sd);
}

TEST(UncertaintyWire, StatesWhatEachParameterIsKnownTo) {
  const json::Value object = uncertainty_to_json(evaluated().assessment);
  for (const char* member : {"value", "mean", "u", "bias", "delta", "mean_error", "u_error"})
    EXPECT_TRUE(at(object, "monte_carlo.R_up").find(member)->is(json::Kind::number)) << member;
  EXPECT_EQ(at(object, "monte_carlo.R_up.symmetric").items().size(), 2u);
  EXPECT_EQ(at(object, "monte_carlo.R_up.shortest").items().size(), 2u);
  EXPECT_EQ(at(object, "monte_carlo.R_up.histogram.counts").items().size(), 40u);
  EXPECT_TRUE(at(object, "monte_carlo.R_up.stable").boolean());
  for (const char* member : {"value", "u", "U", "k"})
    EXPECT_TRUE(at(object, "gum.E").find(member)->is(json::Kind::number)) << member;
  EXPECT_TRUE(at(object, "gum.E.nu_eff").is(json::Kind::null));
  EXPECT_EQ(at(object, "gum.E.coverage").text(), "normal");
}

TEST(UncertaintyWire, DescribesTheRunAndTheBudget) {
  const json::Value object = uncertainty_to_json(evaluated().assessment);
  EXPECT_EQ(at(object, "monte_carlo_run.measurand").text(), "this-test");
  EXPECT_TRUE(at(object, "monte_carlo_run.type_a").is(json::Kind::null));
  EXPECT_EQ(at(object, "monte_carlo_run.trials").number(), 1e6);
  EXPECT_EQ(at(object, "monte_carlo_run.seed").number(), 7.0);
  EXPECT_EQ(at(object, "monte_carlo_run.inputs").items()[0].find("distribution")->text(), "uniform 0.9 1.1");
  EXPECT_EQ(at(object, "monte_carlo_run.contributions").items().size(), 2u);
  EXPECT_EQ(at(object, "gum_budget.positions").items().size(), 11u);
  EXPECT_EQ(at(object, "gum_budget.sources").items().size(), at(object, "gum_budget.contributions").items().size());
}

TEST(UncertaintyWire, HasTheMeansOfEveryTargetByTheContributorsOfAnnexA) {
  Evaluated e = evaluated();
  const auto& annex = *e.assessment.annex_a;
  const json::Value object = uncertainty_to_json(e.assessment);
  const auto& rows = at(object, "annex_a_budget.positions").items();
  ASSERT_EQ(rows.size(), annex.positions.size());
  EXPECT_EQ(rows.back().find("target")->number(), annex.positions.back().target.in_native());
  EXPECT_EQ(rows.back().find("length_m")->number(), annex.positions.back().length_m);
  EXPECT_EQ(at(rows.back(), "mean.U").number(), annex.positions.back().mean->U.in_native());
  EXPECT_EQ(rows.back().find("contributions")->find("eve"), nullptr) << "each mean has its own";
  EXPECT_EQ(at(object, "annex_a_budget.missing").items().size(), annex.missing.size());
  EXPECT_EQ(at(object, "annex_a_budget.datum").number(), annex.datum.in_native());
}

TEST(UncertaintyWire, KeepsEveryDigitOfALargeSeed) {
  Evaluated e = evaluated();
  e.assessment.monte_carlo->seed = 18446744073709551615u;
  const json::Value object = uncertainty_to_json(e.assessment);
  EXPECT_EQ(at(object, "monte_carlo_run.seed").text(), "18446744073709551615");
}

TEST(UncertaintyWire, IsNullWhereAMethodWasNotRunOrAParameterDoesNotExist) {
  Evaluated e = evaluated();
  e.assessment.monte_carlo->distributions[0].reset();
  EXPECT_TRUE(at(uncertainty_to_json(e.assessment), "monte_carlo.A").is(json::Kind::null));
  e.assessment.monte_carlo.reset();
  e.assessment.gum.reset();
  const json::Value object = uncertainty_to_json(e.assessment);
  EXPECT_TRUE(at(object, "gum").is(json::Kind::null));
  EXPECT_TRUE(at(object, "monte_carlo").is(json::Kind::null));
  EXPECT_EQ(object.find("monte_carlo_run"), nullptr);
}

TEST(CombinedCsv, HasColumnsForTheMethodsThatWereAskedFor) {
  const auto columns = [](const std::string& row) { return std::ranges::count(row, ','); };
  const UncertaintyOptions none;
  const UncertaintyOptions both{.gum = true, .monte_carlo = true, .trials = {}};
  const Evaluated e = evaluated();
  EXPECT_EQ(method_csv_header(none), "");
  EXPECT_THAT(method_csv_header(both), StartsWith(",gum_U_A,gum_U_A_up,"));
  EXPECT_THAT(method_csv_header(both), HasSubstr(",mc_mean_A,"));
  EXPECT_THAT(method_csv_header(both), EndsWith(",mc_high_B_mean"));
  for (const UncertaintyOptions& asked : {none, both}) {
    const auto count = columns(combined_csv_header(asked));
    EXPECT_EQ(columns(combined_csv_row(e, asked)), count);
    EXPECT_EQ(columns(combined_csv_error_row("x.csv", {"bad", "", {}}, asked)), count);
  }
}

TEST(CombinedCsv, LeavesEmptyWhatAMethodDoesNotSay) {
  Evaluated e = evaluated();
  e.assessment.gum.reset();
  EXPECT_EQ(method_csv_cells({.gum = true, .monte_carlo = false, .trials = {}}, &e), ",,,,,,,,,,,,");
}

}  // namespace
}  // namespace axiometry::app
