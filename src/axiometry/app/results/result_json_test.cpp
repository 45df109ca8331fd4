// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/result_json.h"

#include <gtest/gtest.h>

#include "axiometry/app/results/outputs.h"
#include "tests/support/made_up_monte_carlo.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

/// With as many members as a result can have.
Evaluated full_result() {
  axiometry::Test test = testing_support::table2::complete_test();
  test.metadata.instrument.gain = 2;
  EvaluateOptions options;
  options.corrections.gain = true;
  options.uncertainty.gum = true;
  options.metadata = {{"tolerance.E", "20"}, {"tolerance.R", "1"}, {"machine.location", "hall \"2\"\tleft"}};
  Evaluated evaluated = evaluate_test(std::move(test), options).value();
  evaluated.name = "of many";
  evaluated.assessment.monte_carlo = testing_support::made_up_monte_carlo(evaluated.assessment.evaluation);
  evaluated.tolerance_band = {.file = "table.csv", .sha256 = "00", .name = "band", .travel_max = {}};
  evaluated.verified.emplace();
  return evaluated;
}

TEST(ResultJson, IsTheSameAsALineAndAsATree) {
  const Evaluated full = full_result();
  const json::Value tree = to_json(full);
  for (const char* name : {"verdict", "tolerances", "tolerance_table", "symbols", "readings", "verification"})
    EXPECT_NE(tree.find(name), nullptr) << name;
  EXPECT_EQ(json_line(full), json::dump(tree, 0));

  const Series one_way = testing_support::make_series({0, 1}, {{0, 1}, {3, 1}}, {});
  const Evaluated bare = evaluate_test({{}, one_way, {}}, {}).value();
  EXPECT_EQ(json_line(bare), json::dump(to_json(bare), 0));
}

}  // namespace
}  // namespace axiometry::app
