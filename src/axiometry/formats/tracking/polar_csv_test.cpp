// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/polar_csv.h"

#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

TEST(PolarCsv, ReadsLengthsAndAnglesInTheUnitsOfTheirHeads) {
  const auto file = read_polar(
      "point,station,length [m],azimuth_mrad,zenith_deg,u_length_um,u_azimuth_arcsec,u_elevation_urad,temperature\n"
      "P1,T,2.5,1000,60,12,2,10,21\n"
      "P2,T,1,-,-,,,,22\n"
      "P3,T,,1,2,3,4,5,23\n");
  ASSERT_TRUE(file) << file.error().to_string();
  ASSERT_EQ(file->rows.size(), 2u);
  EXPECT_DOUBLE_EQ(file->rows[0].length_mm, 2500.0);
  EXPECT_NEAR(file->rows[0].angles->azimuth_deg, 57.29577951308232, 1e-9);
  EXPECT_DOUBLE_EQ(file->rows[0].angles->elevation_deg, 30.0);
  EXPECT_NEAR(*file->rows[0].length_u_mm, 0.012, 1e-15);
  EXPECT_NEAR(*file->rows[0].angles->azimuth_u_arcsec, 2.0, 1e-12);
  EXPECT_NEAR(*file->rows[0].angles->elevation_u_arcsec, 2.0626480624709638, 1e-9);
  EXPECT_FALSE(file->rows[1].angles);
  EXPECT_FALSE(file->rows[1].length_u_mm);
  ASSERT_EQ(file->remarks.size(), 2u);
  EXPECT_EQ(file->remarks[0], "passed over the column \"temperature\"");
  EXPECT_EQ(file->remarks[1], "passed over 1 row without a length");
}

TEST(PolarCsv, TakesLengthsOfAStationWithAnglesForDistances) {
  const std::string head = "point,station,length_mm,azimuth_deg,elevation_deg,segment\n";
  const auto early = read_polar(head + "A,S,-5,,,1\nA,T,-5,,,1\nB,S,1000,0,0,1\n");
  ASSERT_FALSE(early);
  EXPECT_EQ(early.error().at.line, 2u);
  EXPECT_EQ(early.error().at.column, 5u);
  EXPECT_NE(early.error().message.find("at a station with angles"), std::string::npos) << early.error().message;
  const auto other = read_polar(head + "A,T,-5,,,1\nB,T,-6,,,2\nB,S,1000,0,0,1\nB,S,1000,,,2\n");
  ASSERT_TRUE(other) << other.error().to_string();
  ASSERT_EQ(other->remarks.size(), 1u);
  EXPECT_EQ(other->remarks[0], "segments of station \"S\" are not used: it shows angles, and so distances");
}

TEST(PolarCsv, RefusesWhatCannotBe) {
  const std::string head = "point,station,length_mm,azimuth_deg,elevation_deg,u_azimuth_arcsec\n";
  for (const auto& [row, at] : {std::pair{"P,T,100,10,95,1", 12u},
                                {"P,T,100,10,,1", 9u},
                                {"P,T,-100,10,5,1", 5u},
                                {"P,T,100,721,5,1", 9u},
                                {"P,T,100,10,5,0", 14u},
                                {"P,T,100,10,5,3601", 14u},
                                {"P,T,nan,10,5,1", 5u}}) {
    const auto file = read_polar(head + row + "\n");
    ASSERT_FALSE(file) << row;
    EXPECT_EQ(file.error().at.line, 2u) << row;
    EXPECT_EQ(file.error().at.column, at) << row << ": " << file.error().message;
  }
  for (const char* bad :
       {"point,station,length_mm,azimuth,elevation_deg\n", "point,station,length_mm,azimuth_mm,elevation_deg\n",
        "point,station,length_deg\n", "point,station\n", ""})
    EXPECT_FALSE(read_polar(std::string(bad) + "P,T,1,2,3\n")) << bad;
  EXPECT_FALSE(read_polar("point,station,length_mm,azimuth_deg\nP,T,1,2\n"));
  EXPECT_FALSE(read_polar("point,station,length_mm,azimuth_deg,elevation_deg,zenith_deg\nP,T,1,2,3,4\n"));
  EXPECT_FALSE(read_polar("point,station,length_mm,u_azimuth_arcsec\nP,T,1,2\n"));
}

}  // namespace
}  // namespace axiometry::formats
