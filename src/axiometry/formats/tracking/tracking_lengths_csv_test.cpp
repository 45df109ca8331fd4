// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/tracking_lengths_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

using ::testing::HasSubstr;

TrackingPlan plan() {
  TrackingPlan plan;
  for (const char* id : {"x", "xyz"}) {
    Plan line;
    set_spatial_line(line.axis, {{0.0, 1.0, 2.0}, {1.0, 0.0, 0.0}});
    line.targets = {Position::native(210.123), Position::native(260.5), Position::native(310.0)};
    line.runs = 2;
    plan.lines.push_back({id, line});
  }
  return plan;
}

TrackingLengths read_lengths(std::string_view text) {
  auto lengths = read_tracking_lengths(text, plan());
  if (!lengths) throw std::logic_error(lengths.error().to_string());
  return *std::move(lengths);
}

std::string error(std::string_view text) {
  const auto lengths = read_tracking_lengths(text, plan());
  return lengths ? "" : lengths.error().to_string();
}

TEST(TrackingLengthsCsv, SayThatTheyWereSimulated) {
  const std::string table = "line,target,direction,run,length_difference_mm\nx,1,up,1,-0.25\n";
  const auto simulated = read_lengths("# Simulated, not measured; seed 1\n" + table);
  EXPECT_EQ(simulated.metadata.conditions.purpose, "simulation");
  ASSERT_EQ(simulated.remarks.size(), 1u);
  EXPECT_EQ(simulated.remarks[0].message, "the lengths are simulated, not measured, as their file says");
  EXPECT_EQ(read_lengths(table).metadata.conditions.purpose, "");
  EXPECT_TRUE(read_lengths("# not simulated\n" + table).remarks.empty());
}

TEST(TrackingLengthsCsv, ReadsOneReadingInARow) {
  const auto lengths = read_lengths(
      "# machine.name: Mill 5\n# a comment\nline,target,direction,run,length_difference_mm,segment,time_s,note\n"
      "x,1,up,1,-0.25,0,1.5,ok\nXYZ,3,-,2,99.5,4,2.5,\n");
  ASSERT_EQ(lengths.rows.size(), 2u);
  EXPECT_FALSE(lengths.in_program_order);
  EXPECT_EQ(lengths.metadata.machine.name, "Mill 5");
  EXPECT_EQ(lengths.rows[0].reading.line, "x");
  EXPECT_EQ(lengths.rows[0].reading.length_difference_mm, -0.25);
  EXPECT_EQ(lengths.rows[1].reading.line, "xyz");
  EXPECT_EQ(lengths.rows[1].reading.approach, (axiometry::Approach{2, Direction::down, 1}));
  EXPECT_EQ(lengths.rows[1].reading.segment, 4u);
  EXPECT_EQ(lengths.rows[1].time_s, 2.5);
  EXPECT_EQ(lengths.rows[1].at, (TextPosition{5, 11}));
  ASSERT_EQ(lengths.remarks.size(), 1u);
  EXPECT_THAT(lengths.remarks[0].message, HasSubstr("note"));
}

TEST(TrackingLengthsCsv, ReadsPositionsAndCountsRuns) {
  const auto lengths = read_lengths("line;position_mm;direction;length [um]\nx;210,12;↑;1500\nx;210,12;↑;1501,5\n");
  ASSERT_EQ(lengths.rows.size(), 2u);
  EXPECT_EQ(lengths.rows[1].reading.approach, (axiometry::Approach{0, Direction::up, 1}));
  EXPECT_NEAR(lengths.rows[1].reading.length_difference_mm, 1.5015, 1e-12);
}

TEST(TrackingLengthsCsv, ReadsLengthsInTheOrderOfTheProgram) {
  const auto lengths = read_lengths("length_difference_mm\n1.5\n-\n2.5\n");
  EXPECT_TRUE(lengths.in_program_order);
  ASSERT_EQ(lengths.rows.size(), 3u);
  EXPECT_TRUE(lengths.rows[1].missing);
  EXPECT_EQ(lengths.rows[2].reading.length_difference_mm, 2.5);
}

TEST(TrackingLengthsCsv, ReadsAColumnAloneWithDecimalCommas) {
  const auto lengths = read_lengths("length_difference_mm\n1,5\n-\n-1202,25\n7\n");
  ASSERT_EQ(lengths.rows.size(), 4u);
  EXPECT_EQ(lengths.rows[0].reading.length_difference_mm, 1.5);
  EXPECT_EQ(lengths.rows[2].reading.length_difference_mm, -1202.25);
}

TEST(TrackingLengthsCsv, ReadsWhatItWrites) {
  const std::vector<LengthReading> readings = {{"x", {2, Direction::down, 1}, 0.1 + 0.2, 0},
                                               {"xyz", {0, Direction::up, 0}, -1234.56789012345, 3}};
  const auto again = read_lengths(write_tracking_lengths(readings));
  ASSERT_EQ(again.rows.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(again.rows[k].reading.line, readings[k].line);
    EXPECT_EQ(again.rows[k].reading.approach, readings[k].approach);
    EXPECT_EQ(again.rows[k].reading.length_difference_mm, readings[k].length_difference_mm);
    EXPECT_EQ(again.rows[k].reading.segment, readings[k].segment);
  }
}

TEST(TrackingLengthsCsv, SaysWhereItIsWrong) {
  const std::string head = "line,target,direction,run,length_difference_mm\n";
  EXPECT_THAT(error(""), HasSubstr("empty"));
  EXPECT_THAT(error("# only\n"), HasSubstr("found no header"));
  EXPECT_THAT(error(head), HasSubstr("found no lengths"));
  EXPECT_THAT(error("line,target,direction,run,length_difference\n"), HasSubstr("1:27: found the column"));
  EXPECT_THAT(error("line,target,direction,run,length_deg\n"), HasSubstr("unit of length"));
  EXPECT_THAT(error("line,target,direction,run\n"), HasSubstr("found no column length_difference_mm"));
  EXPECT_THAT(error("target,length_mm\n1,2\n"), HasSubstr("found no column line"));
  EXPECT_THAT(error(head + "y,1,up,1,0\n"), HasSubstr("2:1: found the line \"y\", expected one of the plan's: x, xyz"));
  EXPECT_THAT(error(head + "x,0,up,1,0\n"), HasSubstr("2:3: found target \"0\" of line x, expected a whole number"));
  EXPECT_THAT(error(head + "x,4,up,1,0\n"), HasSubstr("from 1 to 3"));
  EXPECT_THAT(error(head + "x,1,left,1,0\n"), HasSubstr("2:5: found the direction"));
  EXPECT_THAT(error(head + "x,1,up,0,0\n"), HasSubstr("2:8: found the run"));
  EXPECT_THAT(error(head + "x,1,up,1,nan\n"), HasSubstr("finite number"));
  EXPECT_THAT(error(head + "x,1,up,1,1\nx,1,up,1,1\n"),
              HasSubstr("3:1: found target 1↑ run 1 of line x a second time"));
  EXPECT_THAT(error(head + "x,1,up\n"), HasSubstr("found 3 fields"));
  EXPECT_THAT(error("line,position_mm,direction,length_mm\nx,211,up,1\n"), HasSubstr("nearest is 210.123 mm"));
  EXPECT_THAT(error("length_mm,segment\n1,-1\n"), HasSubstr("2:3: found the segment"));
  EXPECT_THAT(error("length_m\n1e308\n"), HasSubstr("1: found \"1e308\", expected a length up to 1e9 mm"));
  EXPECT_THAT(error("line,position_m,direction,length_mm\nx,1e308,up,1\n"), HasSubstr("expected a length up to"));
  EXPECT_THAT(error("length_mm,length_um\n"), HasSubstr("second time"));
}

}  // namespace
}  // namespace axiometry::formats
