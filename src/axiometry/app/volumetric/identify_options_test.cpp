// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/identify_options.h"

#include <gtest/gtest.h>

#include <string>

namespace axiometry::app {
namespace {

using SmoothnessKind = volumetric::Smoothness::Kind;

volumetric::Smoothness smoothness_in(const std::string& member) {
  const auto value = json::parse("{\"smoothness\": " + member + "}");
  const auto options = identify_options_from(*value);
  EXPECT_TRUE(options) << member;
  return options ? options->smoothness : volumetric::Smoothness{};
}

TEST(IdentifyOptions, TakeSmoothnessAsWordNumberOrTwo) {
  EXPECT_EQ(identify_options_from(*json::parse("{}"))->smoothness.kind, SmoothnessKind::none);
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
  for (const char* member : {"0", "0.09", "-1", "2e6", "[]", "[1, 2, 3]", "[1, 0]", "true", "\"much\"", "\"\"", "null"})
    EXPECT_FALSE(identify_options_from(*json::parse(std::string("{\"smoothness\": ") + member + "}"))) << member;
  for (const char* text : {"", "0", "1,", ",1", "1,2,3", "nan", "inf", "1e9", "automatic"})
    EXPECT_FALSE(parse_smoothness(text)) << text;
}

}  // namespace
}  // namespace axiometry::app
