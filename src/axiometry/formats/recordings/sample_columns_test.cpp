// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/sample_columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "axiometry/formats/recording.h"

namespace axiometry::formats {
namespace {

/// The column that is the position, 0 for the first of the line; what is said instead where it is none.
std::string position_by(std::string_view header, PositionChoice choice = {}) {
  const auto columns = columns_by_header(header, AxisKind::linear, choice);
  return columns ? std::to_string(columns->position) : columns.error().message;
}

TEST(SampleColumns, TakeEverydayNamesOfThePosition) {
  EXPECT_EQ(position_by("time,Current position"), "1");
  EXPECT_EQ(position_by("Time [s],Commanded position [mm],Feedback position [mm]"), "2");
  EXPECT_EQ(position_by("time_s,current_position_mm,target_position_mm"), "1");
  EXPECT_EQ(position_by("time;Position of the feed axis"), "1");
  EXPECT_EQ(position_by("time;Sollposition;Istposition"), "2");
  EXPECT_EQ(position_by("time,command,encoder"), "2");
  EXPECT_EQ(position_by("time_s,position,resistance"), "1") << "\"ist\" is no word of it";
  EXPECT_EQ(position_by("time_s,actual position,actual current,laser temperature"), "1");
}

TEST(SampleColumns, AreNotReadInUnitsThatAreNone) {
  for (const char* const header : {"time_s,X (cm)", "time_s,position_cm", "time_s,position [ft]", "t,X/counts",
                                   "time_s,angle_gon", "time_s,position_rev", "time_s,X cm"})
    EXPECT_THAT(position_by(header), testing::StartsWith("found positions in \"")) << header;
  EXPECT_EQ(position_by("time_s,position (laser)"), "1");
  EXPECT_EQ(position_by("time_s,X_position"), "1");
}

TEST(SampleColumns, TakeNoUnitForAPositionWhereAnotherColumnIsCalledOne) {
  EXPECT_EQ(position_by("time_s,position,lag_um"), "1");
  EXPECT_EQ(position_by("time_s,position,straightness_um"), "1");
  EXPECT_EQ(position_by("Zeit_s;Position;Schleppfehler_um"), "1");
  EXPECT_EQ(position_by("time_s,position error,position"), "2");
  EXPECT_THAT(position_by("time_s,position,gauge_um"),
              testing::HasSubstr("expected the number of the one with the position"));
  EXPECT_THAT(position_by("time_s,lag_um,straightness_um"),
              testing::HasSubstr("expected the number of the one with the position"));
  EXPECT_EQ(position_by("time_s,position_mm,actual"), "1") << "called so, and the only one with a unit";
  EXPECT_EQ(position_by("time_s,deviation_um"), "1") << "nothing else is there";
}

TEST(SampleColumns, TakeWhatIsStatedWhateverItIsCalled) {
  EXPECT_EQ(position_by("time,temperature"), "found the column \"temperature\", expected positions");
  EXPECT_EQ(position_by("time,current"), "found the column \"current\", expected positions");
  EXPECT_EQ(position_by("time,current", {.stated = 0}), "1");
  EXPECT_EQ(position_by("time,speed,count", {.stated = 1}), "2");
  const auto recognised = recognise_recording("time,speed,count\n0,1,2\n1,1,3\n");
  ASSERT_TRUE(recognised) << "else no flag would help";
  EXPECT_EQ((*recognised)->id, "time-position");
}

TEST(SampleColumns, AreDeviationsOrTheFirstAtStandstill) {
  const PositionChoice rest{.at_standstill = true};
  EXPECT_EQ(position_by("time_s,x_mm,y_mm", rest), "1");
  EXPECT_EQ(position_by("time_s,x_mm,position_mm", rest), "2");
  EXPECT_EQ(position_by("time_s,temperature_C,deviation_um", rest), "2");
  EXPECT_EQ(position_by("time_s,deviation_um,position_mm", rest), "1");
  EXPECT_EQ(position_by("time_s,target_mm,x_mm,y_mm", rest), "2");
  EXPECT_EQ(position_by("time_s,temperature,humidity", rest), "found the column \"temperature\", expected positions");
}

}  // namespace
}  // namespace axiometry::formats
