// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/app/periodic/periodic.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/workbench/workbench_json.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

const std::string label = "step cycle (Annex B), not for acceptance";

Evaluated step_cycle() {
  axiometry::Test test = testing_support::table2::complete_test();
  test.metadata.conditions.cycle = TestCycle::step;
  return evaluate_test(std::move(test), {}).value();
}

TEST(LabelOnTheWire, IsAMemberOfTheJson) {
  const auto value = to_json(step_cycle());
  const auto& claims = value.find("claims")->items();
  ASSERT_EQ(claims.size(), 3u);
  EXPECT_EQ(claims[0].find("key")->text(), "computed");
  EXPECT_EQ(claims[1].find("title")->text(), "Tested in accordance with ISO 230-2:2014");
  EXPECT_FALSE(claims[1].find("missing")->items().empty());
  ASSERT_NE(value.find("label"), nullptr);
  EXPECT_EQ(value.find("label")->text(), label);
}

TEST(LabelOnTheWire, IsAColumnOfTheCombinedTable) {
  EXPECT_THAT(combined_csv_header(), EndsWith(",label,uncertainty_method,computed,tested,reported,symbol\r\n"));
  EXPECT_THAT(combined_csv_row(step_cycle()), HasSubstr(",\"" + label + "\",annex-a,no,no,"));
  const UncertaintyOptions all{.gum = true, .monte_carlo = true, .trials = {}};
  const auto columns = [](const std::string& row) { return std::count(row.begin(), row.end(), ','); };
  EXPECT_EQ(columns(combined_csv_header(all)), columns(combined_csv_error_row("f", {"x", "", {}}, all)));
}

TEST(SymbolsOnTheWire, NameAxisAndParameterTogether) {  // 8.2.4
  Evaluated evaluated = step_cycle();
  evaluated.test.metadata.axis.name = "X";
  const auto value = to_json(evaluated);
  ASSERT_NE(value.find("symbols"), nullptr);
  EXPECT_EQ(value.find("symbols")->find("A_up")->text(), "E_XX,A↑");
  EXPECT_EQ(value.find("symbols")->find("B_mean")->text(), "E_XX,B̄");
  EXPECT_THAT(combined_csv_row(evaluated), EndsWith(",E_XX\r\n"));
  evaluated.assessment.evaluation.parameters.R.reset();
  EXPECT_EQ(to_json(evaluated).find("symbols")->find("R"), nullptr) << "what does not exist has no symbol";
  evaluated.test.metadata.axis.name = "long axis";
  EXPECT_EQ(to_json(evaluated).find("symbols"), nullptr);
  EXPECT_THAT(combined_csv_row(evaluated), EndsWith(",\r\n"));
}

TEST(LabelOnTheWire, IsAMemberOfThePeriodicErrorsJson) {
  std::vector<double> targets;
  testing_support::RunDeviations run;
  for (int k = 0; k < 40; ++k) targets.push_back(k), run.push_back(k % 10);
  axiometry::Test test{{}, testing_support::make_series(targets, {run}, {}), {}};
  test.metadata.conditions.cycle = TestCycle::pilgrim;
  auto result = iso230_2::periodic_error(test).value();
  const auto value = to_json(EvaluatedPeriodic{test, result});
  ASSERT_NE(value.find("label"), nullptr);
  EXPECT_EQ(value.find("label")->text(), "pilgrim cycle, not for acceptance");
}

TEST(LabelOnTheWire, IsInTheReadersLanguageInTheListOfTests) {
  store::TestPage page;
  page.rows.emplace_back().label = "one direction of approach only, not for acceptance";
  page.rows.emplace_back();
  const auto label_in = [&](language::Language language, std::size_t row) {
    return to_json(page, {.language = language}).find("tests")->items()[row].find("label")->text();
  };
  EXPECT_EQ(label_in(language::Language::german, 0), "nur eine Anfahrrichtung, nicht für die Abnahme");
  EXPECT_EQ(label_in(language::Language::english, 0), page.rows.front().label);
  EXPECT_EQ(label_in(language::Language::german, 1), "");
}

}  // namespace
}  // namespace axiometry::app
