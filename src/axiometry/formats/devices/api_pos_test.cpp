// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

constexpr std::string_view both =
    "API Position file\r\nPosition   \tBidirectional Avg Error\r\n0.0\t0.0005\r\n-100.0\t0.0012\r\n"
    "Position   \tForward Directional Avg Error\r\n0.0\t0.0001\r\n-100.0\t-.0007\r\n";
constexpr std::string_view reverse = "Position   \tReverse Directional Avg Error\r\n0.0\t0.0009\r\n-100.0\t1.7E-3\r\n";

Result<Test> read_api(const std::string& text) {
  const auto format = recognise(text);
  EXPECT_TRUE(format && (*format)->id == "api-pos");
  return find_format("api-pos")->read(text);
}

TEST(ApiPos, PutsTheAveragesOfEachDirectionInTheirPlace) {
  const auto test = read_api(std::string(both) + std::string(reverse));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.run_count(), 1u);
  EXPECT_EQ(test->series.targets()[0].in_native(), -100);
  EXPECT_NEAR(test->series.reading(0, Direction::up, 0)->in_native(), -0.7, 1e-12);
  EXPECT_NEAR(test->series.reading(0, Direction::down, 0)->in_native(), 1.7, 1e-12);
  EXPECT_TRUE(test->provenance.remarks[0].departs);
}

TEST(ApiPos, KnowsNoReverseErrorsThatAreNotThere) {
  const auto test = read_api(std::string(both));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_FALSE(test->series.has(Direction::down));
  EXPECT_NEAR(test->series.reading(1, Direction::up, 0)->in_native(), 0.1, 1e-12);
}

TEST(ApiPos, SaysThatABidirectionalCurveHasNoDirection) {
  const auto test = read_api(std::string(both.substr(0, both.find("Position   \tForward"))));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_NEAR(test->series.reading(0, Direction::up, 0)->in_native(), 1.2, 1e-12);
  ASSERT_EQ(test->provenance.remarks.size(), 3u);
  EXPECT_TRUE(test->provenance.remarks[1].departs);
  EXPECT_TRUE(test->provenance.remarks[1].message.contains("M"));
}

TEST(ApiPos, RefusesWhatIsBroken) {
  const auto message = [](const std::string& text) {
    const auto test = read_api(text);
    return test ? "no error" : test.error().to_string();
  };
  EXPECT_EQ(message(std::string(both) + std::string(both)),
            "line 9:1: found a second block \"Position   \\x09Bidirectional Avg Error\", expected only that on line 2");
  EXPECT_EQ(message("Position \tForward Directional Avg Error\n0 1\n0 2\n"),
            "line 3:1: found a second reading of target 0↑ run 1, expected only that on line 2");
  EXPECT_EQ(message("Position \tForward Directional Avg Error\n0 1\n10"),
            "line 3:1: found \"10\", expected two numbers: position and error; the file ends here, is it cut off?");
  EXPECT_EQ(message("Position \tForward Directional Avg Error\n"),
            "found no averages, expected rows of position and error below 'Position  Bidirectional Avg Error'");
}

}  // namespace
}  // namespace axiometry::formats
