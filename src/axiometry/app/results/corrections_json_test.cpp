// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/corrections_json.h"

#include <gtest/gtest.h>

#include "axiometry/app/results/result_json.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

json::Value result_of(const CorrectionRequest& corrections) {
  axiometry::Test test = testing_support::table2::complete_test();
  test.metadata.instrument.gain = 2;
  EvaluateOptions options;
  options.corrections = corrections;
  return to_json(evaluate_test(std::move(test), options).value());
}

TEST(Wire, HasWhatWasDoneToTheReadingsAndBothOfEach) {
  const json::Value result = result_of({.gain = true});
  const json::Value& correction = result.find("corrections")->items().at(0);
  EXPECT_EQ(correction.find("id")->text(), "gain");
  EXPECT_EQ(correction.find("details")->items().at(0).find("value")->text(), "2");
  const auto& readings = result.find("readings")->items();
  ASSERT_EQ(readings.size(), 110u);
  EXPECT_EQ(readings[6].find("target")->number(), 6.711);
  EXPECT_EQ(readings[6].find("direction")->text(), "down");
  EXPECT_EQ(readings[6].find("run")->number(), 2);
  EXPECT_EQ(readings[6].find("as_measured")->number(), 2.1);
  EXPECT_NEAR(readings[6].find("deviation")->number(), 4.2, 1e-9);
}

TEST(Wire, HasNoReadingsWhereNothingWasDoneToThem) {
  const json::Value result = result_of({});
  EXPECT_EQ(result.find("corrections"), nullptr);
  EXPECT_EQ(result.find("readings"), nullptr);
}

json::Value drift_of_json(const axiometry::Test& test) {
  return json::tree_of([&](json::Place place) { put_drift(place, test); });
}

TEST(Wire, HasTheDriftPerReadingOrPerHour) {
  const json::Value result = result_of({});
  const json::Value& drift = *result.find("drift");
  EXPECT_NEAR(drift.find("per_reading")->number(), -0.2815082644628112 / 109, 1e-12);
  EXPECT_NEAR(drift.find("standard_uncertainty")->number(), 0.8099583258843761 / 109, 1e-12);
  EXPECT_EQ(drift.find("per_hour"), nullptr);
  axiometry::Test test{{}, testing_support::make_series({0, 1}, {{0, 1}, {3, 1}}, {}), {}};
  test.times_s = {0, 3600, 1800, 5400, 0, 0, 0, 0};
  EXPECT_NEAR(drift_of_json(test).find("per_hour")->number(), 1.5, 1e-12);
  EXPECT_TRUE(drift_of_json({{}, testing_support::make_series({0, 1}, {{0, 1}}, {}), {}}).is(json::Kind::null));
}

}  // namespace
}  // namespace axiometry::app
