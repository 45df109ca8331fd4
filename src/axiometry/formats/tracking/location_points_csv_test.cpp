// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/location_points_csv.h"

#include <gtest/gtest.h>

#include "axiometry/base/read_budget.h"

namespace axiometry::formats {
namespace {

std::string points_error(std::string_view text) {
  const auto file = read_location_points(text);
  return file ? "no error" : file.error().to_string();
}

TEST(LocationPointsCsv, TheColumnsMayStandInAnyOrderBesideOthers) {
  const auto file = read_location_points(
      "# six points\nname,z_mm,y_mm,x_mm,length_difference_mm,temperature\np1,3,2,1,0,20.1\np2,-6,5.5,4,-0.25,20.2\n");
  ASSERT_TRUE(file) << file.error().to_string();
  ASSERT_EQ(file->points.size(), 2);
  EXPECT_EQ(file->points[0].at_mm, (Vector3{1, 2, 3}));
  EXPECT_EQ(file->points[1].at_mm, (Vector3{4, 5.5, -6}));
  EXPECT_EQ(file->points[1].length_difference_mm, -0.25);
  ASSERT_EQ(file->remarks.size(), 1);
  EXPECT_EQ(file->remarks[0], "passed over the columns \"name\", \"temperature\"");
}

TEST(LocationPointsCsv, UnitsOfTheHeaderAreObeyedAndDecimalCommasRead) {
  const auto file = read_location_points("X [m];Y (mm);Z_mm;ΔL [µm]\r\n0,5;\"2,25\";3;1500,5\r\n");
  ASSERT_TRUE(file) << file.error().to_string();
  EXPECT_EQ(file->points[0].at_mm, (Vector3{500, 2.25, 3}));
  EXPECT_DOUBLE_EQ(file->points[0].length_difference_mm, 1.5005);
}

TEST(LocationPointsCsv, AnEmptyFirstCellMovesNothing) {
  const auto file = read_location_points("name\tx_mm\ty_mm\tz_mm\tdl_mm\tnote\n\t1\t2\t3\t4\tfirst\n");
  ASSERT_TRUE(file) << file.error().to_string();
  EXPECT_EQ(file->points[0].at_mm, (Vector3{1, 2, 3}));
  EXPECT_EQ(file->points[0].length_difference_mm, 4);
}

TEST(LocationPointsCsv, MorePointsThanAStationIsLocatedByAreRefused) {
  std::string table = "x_mm,y_mm,z_mm,length_difference_mm\n";
  for (std::size_t k = 0; k < read_budget::location_points; ++k) table += "1,2,3,4\n";
  EXPECT_TRUE(read_location_points(table));
  EXPECT_EQ(points_error(table + "1,2,3,4\n"),
            "line 10002:1: found more than 10000 points, expected fewer to locate a station by");
}

TEST(LocationPointsCsv, WhatIsWrongIsNamedWithItsPlace) {
  const std::string head = "x_mm,y_mm,z_mm,length_difference_mm\n";
  EXPECT_EQ(points_error(head + "1,2,3,4\n1,two,3,4\n"), "line 3:3: found \"two\", expected a finite number");
  EXPECT_EQ(points_error(head + "1,2,,4\n"), "line 2:5: found \"\", expected a finite number");
  EXPECT_EQ(points_error(head + "1,2,nan,4\n"), "line 2:5: found \"nan\", expected a finite number");
  EXPECT_EQ(points_error(head + "1,2,3,4\n1,2,3"),
            "line 3:5: found 3 fields, expected 4 as in the header on line 1; the file ends here, is it cut off?");
  EXPECT_EQ(points_error(head + "1,2,3,4e12\n"), "line 2:7: found \"4e12\", expected a length up to 1e9 mm");
  EXPECT_EQ(points_error("x_mm,y_mm,length_difference_mm\n1,2,3\n"),
            "line 1:1: found no column z_mm, expected a header with x_mm, y_mm, z_mm, length_difference_mm");
  EXPECT_EQ(points_error("x_mm,y_mm,z,length_difference_mm\n"),
            "line 1:11: found the column \"z\" without a unit, expected one as in z_mm");
  EXPECT_EQ(points_error("x_mm,y_mm,z_mm,x_mm,dl_mm\n"),
            "line 1:16: found \"x_mm\" a second time, expected one column of it");
  EXPECT_NE(points_error("x_mm,y_mm,z_mm,dl_deg\n").find("line 1:16: found the unit \"deg\""), std::string::npos);
  EXPECT_EQ(points_error("# nothing\n"),
            "line 1:1: found no header, expected one with x_mm, y_mm, z_mm, length_difference_mm");
  EXPECT_NE(points_error(""), "no error");
}

}  // namespace
}  // namespace axiometry::formats
