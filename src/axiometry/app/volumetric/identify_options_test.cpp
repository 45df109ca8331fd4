// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/identify_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;

std::string written_again(const std::string& text, const RecordingTexts& recording = {}) {
  const auto choices = identify_choices_from(json::parse(text).value());
  return choices ? json::dump(to_json(*choices, recording), 0) : choices.error().message;
}

TEST(IdentifyChoices, AreWrittenAsTheyAreRead) {
  const std::string every =
      R"({"curves":"legendre","spans":[8,6,4],"reversal":"curves","smoothness":[5,8.5],"drift":"linear",)"
      R"("find_breaks":false,"find_outliers":false,"find_part_scales":false,"parts":["1","5-8"],"reversed":true,)"
      R"("recording":{"rate":"1000"}})";
  EXPECT_EQ(written_again(every, {{"rate", "1000"}}), every);
  EXPECT_EQ(written_again(R"({"spans":4})"), R"({"spans":4})");
  EXPECT_EQ(written_again(R"({"spans":[4,4,4]})"), R"({"spans":4})");
  EXPECT_EQ(written_again(R"({"smoothness":"auto"})"), R"({"smoothness":"auto"})");
  EXPECT_EQ(written_again(R"({"smoothness":[5,5]})"), R"({"smoothness":5})");
  EXPECT_EQ(written_again("{}"), "{}") << "nothing of what is as usual";
  EXPECT_EQ(written_again(R"({"reversal":"none","drift":"auto"})"), "{}");
}

TEST(IdentifyChoices, RefuseWhatTheyDoNotHave) {
  EXPECT_THAT(written_again(R"({"parts": ["8-5"]})"), HasSubstr("8-5"));
  EXPECT_THAT(written_again(R"({"parts": [1]})"), HasSubstr("parts"));
  EXPECT_THAT(written_again(R"({"spans": 101})"), HasSubstr("101"));
  EXPECT_THAT(written_again(R"({"tolerances": []})"), HasSubstr("tolerances"));
}

using SmoothnessKind = volumetric::Smoothness::Kind;

volumetric::Smoothness smoothness_in(const std::string& member) {
  const auto value = json::parse("{\"smoothness\": " + member + "}");
  const auto options = identify_choices_from(*value);
  EXPECT_TRUE(options) << member;
  return options ? options->model.smoothness : volumetric::Smoothness{};
}

TEST(IdentifyOptions, TakeSmoothnessAsWordNumberOrTwo) {
  EXPECT_EQ(identify_choices_from(*json::parse("{}"))->model.smoothness.kind, SmoothnessKind::none);
  EXPECT_EQ(smoothness_in("\"none\"").kind, SmoothnessKind::none);
  EXPECT_EQ(smoothness_in("\"auto\"").kind, SmoothnessKind::automatic);
  const auto one = smoothness_in("5");
  EXPECT_EQ(one.kind, SmoothnessKind::stated);
  EXPECT_EQ(one.displacement_um, 5.0);
  EXPECT_EQ(one.rotation_urad, 5.0);
  const auto two = smoothness_in("[5, 8.5]");
  EXPECT_EQ(two.displacement_um, 5.0);
  EXPECT_EQ(two.rotation_urad, 8.5);
  EXPECT_EQ(parse_smoothness("5,8.5")->rotation_urad, 8.5);
}

TEST(IdentifyOptions, RefuseASmoothnessThatIsNone) {
  for (const char* member : {"0", "0.09", "-1", "2e6", "[]", "[1, 2, 3]", "[1, 0]", "true", "\"much\"", "\"\""})
    EXPECT_FALSE(identify_choices_from(*json::parse(std::string("{\"smoothness\": ") + member + "}"))) << member;
  for (const char* text : {"", "0", "1,", ",1", "1,2,3", "nan", "inf", "1e9", "automatic"})
    EXPECT_FALSE(parse_smoothness(text)) << text;
}

}  // namespace
}  // namespace axiometry::app
