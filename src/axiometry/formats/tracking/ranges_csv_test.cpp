// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/ranges_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string ranges_error(std::string_view text) {
  const auto file = read_ranges(text);
  return file ? "no error" : file.error().to_string();
}

TEST(RangesCsv, reads_names_lengths_segments_and_nominal_places) {
  const auto file = read_ranges(
      "# made by hand\n"
      "station;point;length_mm;segment;x_mm;y_mm;z [m]\n"
      "A;P1;100,5;;1;2;0,003\n"
      "A;\"P;2\";-3;;4;5;0,006\r\n"
      "B;P1;7;first;1;2;0,003\n"
      "A;P1;8;2;1;2;0,003");
  ASSERT_TRUE(file) << file.error().to_string();
  EXPECT_THAT(file->points, ElementsAre("P1", "P;2"));
  EXPECT_THAT(file->stations, ElementsAre("A", "B"));
  ASSERT_EQ(file->readings.size(), 4u);
  EXPECT_DOUBLE_EQ(file->readings[0].length_mm, 100.5);
  EXPECT_EQ(file->readings[1].point, 1u);
  EXPECT_EQ(file->readings[2].station, 1u);
  EXPECT_EQ(file->readings[2].segment, 0u);
  EXPECT_EQ(file->readings[3].segment, 1u);
  EXPECT_THAT(file->segments[0], ElementsAre("", "2"));
  ASSERT_EQ(file->nominal_mm.size(), 2u);
  EXPECT_DOUBLE_EQ(file->nominal_mm[1].z, 6.0);
  EXPECT_THAT(file->lines, ElementsAre(3u, 4u));
}

TEST(RangesCsv, passes_over_lost_lengths_and_other_columns_and_says_so) {
  const auto file = read_ranges("point,station,length_um,temperature\n1,1,5000,20\n1,2,,20\n1,3,-,20\n");
  ASSERT_TRUE(file) << file.error().to_string();
  ASSERT_EQ(file->readings.size(), 1u);
  EXPECT_DOUBLE_EQ(file->readings[0].length_mm, 5.0);
  EXPECT_THAT(file->remarks, ElementsAre(HasSubstr("temperature"), HasSubstr("2 rows without a length")));
}

TEST(RangesCsv, knows_the_hint_of_a_spreadsheet) {
  const auto file = read_ranges("sep=;\npoint;station;length_mm\n1;2;3,5\n");
  ASSERT_TRUE(file) << file.error().to_string();
  EXPECT_DOUBLE_EQ(file->readings[0].length_mm, 3.5);
}

TEST(RangesCsv, says_where_something_is_wrong) {
  EXPECT_THAT(ranges_error("point,station\n"), HasSubstr("1:1: found no column length_mm"));
  EXPECT_THAT(ranges_error("point,station,length\n"), HasSubstr("1:15: found the column \"length\" without a unit"));
  EXPECT_THAT(ranges_error("point,station,length_mm,range_mm\n"), HasSubstr("1:25: found \"range_mm\" a second time"));
  EXPECT_THAT(ranges_error("point,station,length_mm\n1,1,5\n1,,6\n"), HasSubstr("3:3: found no station"));
  EXPECT_THAT(ranges_error("point,station,length_mm\n1,1,5\n" + std::string(100'000, ',')),
              HasSubstr("3:32769: found more than 32768 fields in one row"));
  EXPECT_THAT(ranges_error("point,station,length_mm\n1,1,5.0\n1,1,nan\n"), HasSubstr("3:5: found \"nan\""));
  EXPECT_THAT(ranges_error("point,station,length_mm\n1,1,1e12\n"), HasSubstr("2:5: found \"1e12\", expected a length"));
  EXPECT_THAT(ranges_error("point,station,length_mm\n1,1\n"), HasSubstr("2:3: found 2 fields"));
  EXPECT_THAT(ranges_error("point,station,length_mm\n"), HasSubstr("no lengths below"));
  EXPECT_THAT(ranges_error("point,station,length_mm,x_mm\n"), HasSubstr("found 1 of the columns"));
  EXPECT_THAT(ranges_error(""), HasSubstr("empty"));
  EXPECT_THAT(ranges_error("point,station,length_mm,x_mm,y_mm,z_mm\nP,1,5,1,2,3\nP,2,5,1,2,4\n"),
              HasSubstr("3:7: found point P at (1, 2, 4), expected (1, 2, 3) as on line 2"));
}

TEST(RangesCsv, reads_nominal_points_and_refuses_one_given_twice) {
  const auto points = read_named_points("point\tx_mm\ty_mm\tz_mm\nP1\t1\t2\t3\nP2\t4\t5\t6.5\n");
  ASSERT_TRUE(points) << points.error().to_string();
  EXPECT_THAT(points->names, ElementsAre("P1", "P2"));
  EXPECT_DOUBLE_EQ(points->at_mm[1].z, 6.5);
  const auto twice = read_named_points("point,x_mm,y_mm,z_mm\nP1,1,2,3\nP1,1,2,3\n");
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().to_string(), "line 3:1: found point P1 a second time, expected it once as on line 2");
}

}  // namespace
}  // namespace axiometry::formats
