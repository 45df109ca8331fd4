// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/evaluate_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "axiometry/language/language.h"

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;

json::Value options_value(const std::string& text) { return json::parse(text).value(); }

std::string refused_options(const std::string& text) {
  const auto options = evaluate_options_from(options_value(text));
  if (options) ADD_FAILURE() << text << " was taken";
  return options ? "" : options.error().message;
}

/// All members, none of them as usual.
constexpr const char* every_option = R"({"tolerances":["A=10um","xy:E=20um"],"tolerance_table":"Grinder",)"
                                     R"("rule":"guard-band=3um","set":["machine.name=Mill 5, left=right"],)"
                                     R"("reversed":true,"find_breaks":false,"break_threshold_mm":0.05,)"
                                     R"("methods":["gum","monte-carlo"],"trials":20000,"seed":7,"coverage":0.9,)"
                                     R"("type_a":"resampled","recording":{"rate":"1000","skip-damaged":"1"}})";

TEST(EvaluateOptions, AreWrittenAsTheyAreRead) {
  const auto options = evaluate_options_from(options_value(every_option));
  ASSERT_TRUE(options) << options.error().to_string();
  EXPECT_EQ(json::dump(to_json(*options, {{"rate", "1000"}, {"skip-damaged", "1"}}), 0), every_option);
  EXPECT_EQ(options->metadata.at(0).second, "Mill 5, left=right");
  EXPECT_EQ(options->uncertainty.trials.type_a, iso230_2::TypeA::resampled);
  EXPECT_EQ(options->recording.recording.rate_hz, 1000.0);
  EXPECT_TRUE(options->recording.recording.skip_damaged);
  EXPECT_EQ(options->line_tolerances.at(0).line, "xy");
  for (const char* rule : {"simple", "iso14253-1", "guard-band=0.003mm"}) {
    const std::string text = std::string(R"({"rule":")") + rule + "\"}";
    EXPECT_EQ(json::dump(to_json(*evaluate_options_from(options_value(text)), {}), 0), text);
  }
}

TEST(EvaluateOptions, WriteNothingOfWhatIsAsUsual) { EXPECT_EQ(json::dump(to_json({}, {}), 0), "{}"); }

TEST(EvaluateOptions, RefuseWhatTheyDoNotHave) {
  EXPECT_THAT(refused_options(R"({"find_outliers": true})"), HasSubstr("find_outliers"));
  EXPECT_THAT(refused_options(R"({"set": ["machine.name"]})"), HasSubstr("KEY=VALUE"));
  EXPECT_THAT(refused_options(R"({"set": ["machine.colour=red"]})"), HasSubstr("machine.colour"));
  EXPECT_THAT(refused_options(R"({"methods": ["guess"]})"), HasSubstr("guess"));
  EXPECT_THAT(refused_options(R"({"trials": 1e9})"), HasSubstr("10000000"));
  EXPECT_THAT(refused_options(R"({"type_a": "bayes"})"), HasSubstr("pooled"));
  EXPECT_THAT(refused_options(R"({"recording": {"datum": "3"}})"), HasSubstr("datum"));
  EXPECT_THAT(refused_options(R"({"recording": {"rate": "often"}})"), HasSubstr("rate"));
  EXPECT_THAT(refused_options(R"({"recording": 5})"), HasSubstr("an object"));
  for (const char* text : {R"({"set": ["machine.name"]})", R"({"recording": {"zero": "first-target"}})"}) {
    const std::string message = refused_options(text);
    EXPECT_TRUE(language::is_known(message, language::Language::german)) << message;
  }
}

TEST(EvaluateOptions, TakeATableOfTolerancesWithItsFileAlone) {
  ToleranceOptions tolerance;
  EXPECT_TRUE(take_tolerances(std::nullopt, tolerance));
  EXPECT_FALSE(tolerance.table);
  tolerance.table_name = "Grinder";
  const auto alone = take_tolerances(std::nullopt, tolerance);
  ASSERT_FALSE(alone);
  EXPECT_TRUE(language::is_known(alone.error().message, language::Language::german));
  const auto wrong = take_tolerances(GivenFile{"limits.csv", "no table"}, tolerance);
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().to_string(), HasSubstr("limits.csv"));
  ASSERT_TRUE(
      take_tolerances(GivenFile{"limits.csv", "name,kind,travel_up_to,unit,A\nGrinder,linear,,um,12\n"}, tolerance));
  EXPECT_EQ(tolerance.table->bands.size(), 1u);
}

}  // namespace
}  // namespace axiometry::app
