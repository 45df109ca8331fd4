// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace axiometry::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refusal_of_lengths(std::string_view text) {
  const auto lengths = read_volumetric_lengths(text);
  return lengths ? "none" : lengths.error().to_string();
}

TEST(VolumetricLengthsCsv, NamesAreNumberedAsTheyCome) {
  const auto lengths = read_volumetric_lengths(
      "# a "
      "comment\nstation,tool,x_mm,y_mm,z_mm,length_mm\nB,long,1,2,3,400.5\nA,short,4,5,6,500.25\nB,short,7,8,9,1\n");
  ASSERT_TRUE(lengths) << lengths.error().to_string();
  EXPECT_THAT(lengths->stations, ElementsAre("B", "A"));
  EXPECT_THAT(lengths->tools, ElementsAre("long", "short"));
  ASSERT_EQ(lengths->readings.size(), 3u);
  EXPECT_EQ(lengths->readings[2].station, 0u);
  EXPECT_EQ(lengths->readings[2].tool, 1u);
  EXPECT_EQ(lengths->readings[1].axes_mm, (Vector3{4, 5, 6}));
  EXPECT_DOUBLE_EQ(lengths->readings[1].length_mm, 500.25);
  EXPECT_EQ(lengths->readings[1].line, 4u);
}

TEST(VolumetricLengthsCsv, UnitsAreThoseOfTheHeads) {
  const auto lengths = read_volumetric_lengths("station,tool,x_in,y_in,z_in,length_m\nA,T,1,2,-3,0.5\n");
  ASSERT_TRUE(lengths) << lengths.error().to_string();
  EXPECT_DOUBLE_EQ(lengths->readings[0].axes_mm.x, 25.4);
  EXPECT_DOUBLE_EQ(lengths->readings[0].axes_mm.z, -76.2);
  EXPECT_DOUBLE_EQ(lengths->readings[0].length_mm, 500.0);
}

TEST(VolumetricLengthsCsv, RowsWithoutALengthArePassedOverAndTold) {
  const auto lengths = read_volumetric_lengths("station,tool,x_mm,y_mm,z_mm,length_mm\nA,T,1,2,3,\nA,T,1,2,3,4\n");
  ASSERT_TRUE(lengths) << lengths.error().to_string();
  EXPECT_EQ(lengths->readings.size(), 1u);
  EXPECT_THAT(lengths->remarks, ElementsAre("passed over 1 row without a length"));
}

TEST(VolumetricLengthsCsv, SayThatTheyWereSimulated) {
  const std::string table = "station,tool,x_mm,y_mm,z_mm,length_mm\nA,T,1,2,3,4\n";
  EXPECT_THAT(read_volumetric_lengths("# Simulated, not measured; seed 1\n" + table)->remarks,
              ElementsAre("the lengths are simulated, not measured, as their file says"));
  EXPECT_THAT(read_volumetric_lengths(table)->remarks, ElementsAre());
}

TEST(VolumetricLengthsCsv, NamesWithCommasQuotesAndMarksAreReadBack) {
  volumetric::VolumetricLengths lengths{{"#1", "A, left", "say \"B\""}, {"T,1"}, {"1"}, {}, {}};
  for (std::size_t s = 0; s < 3; ++s) lengths.readings.push_back({s, 0, 0, {1.5, 2, 3}, 100.0 + 0.125, 0});
  const auto again = read_volumetric_lengths(write_volumetric_lengths(lengths));
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(again->stations, lengths.stations);
  EXPECT_EQ(again->tools, lengths.tools);
  EXPECT_DOUBLE_EQ(again->readings[2].length_mm, 100.125);
}

TEST(VolumetricLengthsCsv, RefusesTablesThatAreNone) {
  EXPECT_THAT(refusal_of_lengths("station,tool,x_mm,y_mm,z_mm\nA,T,1,2,3\n"), HasSubstr("length"));
  EXPECT_THAT(refusal_of_lengths("station,tool,x_mm,y_mm,z_mm,length_mm\n"), HasSubstr("no lengths below it"));
  EXPECT_THAT(refusal_of_lengths("station,tool,x_mm,y_mm,z_mm,length_mm\nA,T,1,2,three,4\n"), HasSubstr("three"));
}

TEST(VolumetricLengthsCsv, PointsNeedNoTool) {
  const auto points = read_volume_points("x_mm,y_mm,z_mm\n1,2,3\n");
  ASSERT_TRUE(points) << points.error().to_string();
  EXPECT_EQ(points->points.front().tool, "");
  EXPECT_EQ(points->points.front().axes_mm, (Vector3{1, 2, 3}));
}

}  // namespace
}  // namespace axiometry::formats
