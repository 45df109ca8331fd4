// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/motions/motion_result.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace axiometry::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view whole_result =
    R"({"result": "straightness", "straightness": {"error": "EYX", "read_positive": "-Y", "unit": "um",
"reference": "least-squares", "runs": 2, "instrument": {"U_constant": 0.4, "U_per_m": 0.5},
"positions": {"position_mm": [0, 10], "up": {"mean": [1, 2], "s": [0.1, 0.2]},
"down": {"mean": [3, 4], "s": [0.3, 0.4]}, "mean": {"mean": [2, 3]}}, "remarks": ["a"]}, "program": {}})";

std::string with(std::string_view from, std::string_view to) {
  std::string text(whole_result);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error(std::string(from));
  return text.replace(at, from.size(), to);
}

TEST(MotionResult, IsReadAsItIsWritten) {
  const auto results = read_motion_result(whole_result);
  ASSERT_TRUE(results) << results.error().to_string();
  const MotionResult& m = results->motions.at(0);
  EXPECT_EQ(m.error->text(), "EYX");
  EXPECT_TRUE(m.sense->negative);
  EXPECT_THAT(m.means, ElementsAre(2, 3));
  EXPECT_THAT(m.s_up, ElementsAre(0.1, 0.2));
  EXPECT_THAT(m.s_down, ElementsAre(0.3, 0.4));
  EXPECT_EQ(m.instrument_U, 0.4);
  EXPECT_EQ(m.instrument_U_per_m, 0.5);
  EXPECT_THAT(m.remarks, ElementsAre("a"));
}

TEST(MotionResult, IsNoTableOfReadings) {
  EXPECT_TRUE(looks_like_motion_result("\xEF\xBB\xBF \n{"));
  EXPECT_FALSE(looks_like_motion_result("position_mm"));
  EXPECT_FALSE(looks_like_motion_result(""));
}

TEST(MotionResult, RefusesWhatIsNone) {
  const std::pair<std::string, std::string_view> faults[] = {
      {"{}", "found no \"result\""},
      {"[]", "found array, expected an object"},
      {with("\"straightness\", \"str", "\"volumetric\", \"str"), "found the result \"volumetric\""},
      {with("\"um\"", "\"mm\""), "2"},
      {with("\"um\"", "\"urad\""), "EYX in µrad, expected readings of a length"},
      {with("\"EYX\"", "\"EYQ\""), "found the error \"EYQ\""},
      {with("\"-Y\"", "\"Y\""), "found \"Y\" as the way"},
      {with("[0, 10]", "[0, 0]"), "do not ascend"},
      {with("[0, 10]", "[0]"), "fewer than two"},
      {with("[0, 10]", "[0, 10, 20]"), "found 2 numbers in \"mean\", expected 3"},
      {with("[1, 2], \"s\"", "[1, \"x\"], \"s\""), "\"mean\" of the kind string"},
      {with("[0.1, 0.2]", "[0.1, -0.2]"), "below 0"},
      {with("[1, 2]", "[1, 1e300]"), "above 1e9"},
      {with("\"mean\": {\"mean\": [2, 3]}", "\"more\": 1"), "found no means"},
      {with("\"runs\": 2", "\"runs\": 1.5"), "found 1.5 runs"},
      {with("\"runs\": 2", "\"runs\": 0"), "found 0 runs"},
      {with(", \"s\": [0.1, 0.2]", ""), "found no \"s\""},
      {with("0.4, \"U_per_m\"", "-0.4, \"U_per_m\""), "below 0"},
      {with("\"up\": {\"mean\": [1, 2]", "\"up\": {\"mean\": 1"), "\"mean\""},
      {R"({"result": "angles", "angles": []})", "found no errors"},
  };
  for (const auto& [text, message] : faults) {
    const auto results = read_motion_result(text);
    ASSERT_FALSE(results) << text;
    EXPECT_THAT(results.error().to_string(), HasSubstr(std::string(message))) << text;
  }
}

TEST(MotionResult, OfSquarenessHasTwoLines) {
  const std::string line(whole_result.substr(whole_result.find("{\"error\""))
                             .substr(0, whole_result.find(", \"program\"") - whole_result.find("{\"error\"")));
  const std::string location =
      R"("location_error": {"name": "C0Y", "urad": {"value": -3.5, "k": null, "u_scatter": null,)"
      R"( "u_instrument": 0.2}})";
  const auto of = [&](const std::string& lines) {
    return read_motion_result("{\"result\": \"squareness\", \"lines\": [" + lines +
                              "], \"square_error_arcsec\": 0.5, " + location + "}");
  };
  const auto both = of(line + "," + line);
  ASSERT_TRUE(both) << both.error().to_string();
  EXPECT_EQ(both->location->urad, -3.5);
  EXPECT_EQ(both->location->u_instrument_urad, 0.2);
  EXPECT_EQ(both->location->u_scatter_urad, 0.0);
  EXPECT_FALSE(both->location->k);
  EXPECT_EQ(both->square_error_arcsec, 0.5);
  EXPECT_FALSE(both->square_U_arcsec);
  const auto one = of(line);
  ASSERT_FALSE(one);
  EXPECT_THAT(one.error().to_string(), HasSubstr("found 1 in \"lines\""));
}

}  // namespace
}  // namespace axiometry::formats
