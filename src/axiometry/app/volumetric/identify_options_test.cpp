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
  const std::string every = R"({"curves":"legendre","spans":[8,6,4],"reversal":"curves","drift":"linear",)"
                            R"("find_breaks":false,"find_outliers":false,"parts":["1","5-8"],"reversed":true,)"
                            R"("recording":{"rate":"1000"}})";
  EXPECT_EQ(written_again(every, {{"rate", "1000"}}), every);
  EXPECT_EQ(written_again(R"({"spans":4})"), R"({"spans":4})");
  EXPECT_EQ(written_again(R"({"spans":[4,4,4]})"), R"({"spans":4})");
  EXPECT_EQ(written_again("{}"), "{}") << "nothing of what is as usual";
  EXPECT_EQ(written_again(R"({"reversal":"none","drift":"auto"})"), "{}");
}

TEST(IdentifyChoices, RefuseWhatTheyDoNotHave) {
  EXPECT_THAT(written_again(R"({"parts": ["8-5"]})"), HasSubstr("8-5"));
  EXPECT_THAT(written_again(R"({"parts": [1]})"), HasSubstr("parts"));
  EXPECT_THAT(written_again(R"({"spans": 101})"), HasSubstr("101"));
  EXPECT_THAT(written_again(R"({"tolerances": []})"), HasSubstr("tolerances"));
}

}  // namespace
}  // namespace axiometry::app
