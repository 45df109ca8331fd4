// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/volumetric_plan_json.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "axiometry/formats/volumetric/true_errors_json.h"
#include "tests/support/json_schema.h"

namespace axiometry::formats {
namespace {

using volumetric::CalibrationPlan;

CalibrationPlan small_volumetric_plan() {
  CalibrationPlan plan{.date = "2026-11-25", .machine = {.chain = *volumetric::KinematicChain::make("YXFZ")}};
  plan.machine.travel = {{0, 0, -400}, {500, 300, 0}};
  plan.machine.tools = {{"T1", {0, 0, -120}}, {"T2", {100, 0, -200}}};
  plan.machine.stations = {{"S1", {10, 20, -700}}};
  plan.limits.incidence_most_deg = 70.0;
  plan.obstacles = {{"vice", BoxObstacle{{200, 100, -700}, {260, 160, -600}}}};
  plan.feed_mm_per_min = 2500.0;
  plan.dwell = Duration::s(4.0);
  plan.runs = {{0, 1, {{{1, 2, -3}}, {{4, 5, -6}, {{4, 5, 0}, {1, 2, 0}}, false}}}, {0, 0, {{{7, 8, -9}}}}};
  return plan;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(VolumetricPlanJson, ReadsBackWhatItWrites) {
  const std::string text = write_volumetric_plan(small_volumetric_plan());
  EXPECT_TRUE(is_volumetric_plan(text));
  const auto back = read_volumetric_plan(text);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(write_volumetric_plan(*back), text);
  EXPECT_EQ(back->runs[0].stops, small_volumetric_plan().runs[0].stops);
  EXPECT_EQ(back->runs[0].tool, 1u);
  EXPECT_EQ(back->obstacles.size(), 1u);
  EXPECT_EQ(back->limits.incidence_most_deg, 70.0);
}

TEST(VolumetricPlanJson, WritesWhatItsSchemaAllows) {
  const json::Value published = volumetric_plan_schema();
  json::Value schema = json::Value::object();  // without what names it
  for (const auto& [name, value] : published.members())
    if (name[0] != '$' && name != "title") schema.add(name, value);
  const auto plan = json::parse(write_volumetric_plan(small_volumetric_plan()));
  ASSERT_TRUE(plan);
  const testing_support::JsonSchemas schemas(schema);
  EXPECT_TRUE(schemas.faults(schema, *plan).empty());
  const auto wrong = json::parse(replaced(write_volumetric_plan(small_volumetric_plan()), "\"runs\"", "\"rums\""));
  EXPECT_FALSE(schemas.faults(schema, *wrong).empty());
}

TEST(VolumetricPlanJson, RefusesWhatIsNoPlanSayingWhere) {
  const std::string text = write_volumetric_plan(small_volumetric_plan());
  const auto refused = [&](std::string_view from, std::string_view to, std::string_view message) {
    const auto result = read_volumetric_plan(replaced(text, from, to));
    ASSERT_FALSE(result) << from;
    EXPECT_NE(result.error().message.find(message), std::string::npos) << result.error().message;
    EXPECT_GT(result.error().at.line, 0u) << result.error().message;
  };
  refused("axiometry-volumetric-plan/1", "axiometry-volumetric-plan/9", "another \"format\"");
  refused("\"tool\": \"T2\"", "\"tool\": \"T9\"", "the tool \"T9\"");
  refused("\"tool\": \"T2\"", "\"tool\": \"T1\"", "a second time");
  refused("\"dwell_s\": 4", "\"dwell_s\": -4", "dwell_s");
  refused("\"date\"", "\"dates\"", "dates");
  refused("\"date\": \"", "\"date\": \"2026-02-30 ", "the date of the plan");
  EXPECT_FALSE(is_volumetric_plan("{}"));
  EXPECT_FALSE(is_volumetric_plan("no"));
}

TEST(VolumetricPlanJson, RefusesAStopOutsideOfTheTravel) {
  CalibrationPlan plan = small_volumetric_plan();
  plan.runs[1].stops[0].axes_mm.x = 501.0;
  const auto result = read_volumetric_plan(write_volumetric_plan(plan));
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("expected it within its travel"), std::string::npos);
}

TEST(TrueErrorsJson, ReadsBackWhatItWritesAndWhatIdentifyWrites) {
  const TravelBox travel = {{0, 0, -400}, {500, 300, 0}};
  const volumetric::TrueErrors errors = volumetric::drawn_errors(travel, {}, {.seed = 3});
  json::Value root = json::Value::object();
  root.add("errors", true_errors_value(errors));
  const auto back = read_true_errors(json::dump(root), small_volumetric_plan().machine);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->squareness_urad, errors.squareness_urad);
  EXPECT_EQ(back->curves[2][4].at(-123.0), errors.curves[2][4].at(-123.0));
  const auto few = read_true_errors(
      R"({"errors": {"EXX": [{"position": 0, "value": 1}, {"position": 500, "value": 3, "u": 2}]}, "rank": {}})",
      small_volumetric_plan().machine);
  ASSERT_TRUE(few) << few.error().message;
  EXPECT_EQ(few->curves[0][0].at(250.0), 2.0);
  EXPECT_EQ(few->curves[1][0].at(250.0), 0.0);
}

TEST(TrueErrorsJson, RefusesWhatIsNotTold) {
  for (const char* errors :
       {R"({"EXX": []})", R"({"C0Y": {"value": null}})", R"({"EXQ": []})", R"({"EXX": [{"position": 1}]})",
        R"({"EXX": [{"position": 100, "value": 1}, {"position": 500, "value": 3}]})", R"([])"}) {
    const auto result = read_true_errors(std::string("{\"errors\": ") + errors + "}", small_volumetric_plan().machine);
    EXPECT_FALSE(result) << errors;
  }
  EXPECT_FALSE(read_true_errors("{}", small_volumetric_plan().machine));
}

}  // namespace
}  // namespace axiometry::formats
