// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_text.h"

#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

TEST(TrackingText, ReadsTravelsInAnyOrderAndUnit) {
  const auto box = parse_travel_box("Z=-300:0, x=0:0.5m,Y=-10.5:400");
  ASSERT_TRUE(box);
  EXPECT_EQ(box->lowest_mm, (Vector3{0, -10.5, -300}));
  EXPECT_EQ(box->highest_mm, (Vector3{500, 400, 0}));
  for (std::string_view bad : {"", "X=0:500", "X=0:500,Y=0:400,Y=0:300", "X=500:0,Y=0:1,Z=0:1", "X=0:0,Y=0:1,Z=0:1",
                               "X=0:1,Y=0:1,Z=nan:1", "X=0:1,Y=0:1,A=0:1", "X=0:1,Y=0:1,Z=", "X=0:1,Y=0:1,Z=0:1kg"})
    EXPECT_FALSE(parse_travel_box(bad)) << bad;
}

TEST(TrackingText, ReadsRangesAndElevations) {
  EXPECT_EQ(parse_range("0.2m:15m")->low, 200);
  EXPECT_EQ(parse_range("0.2m:15m")->high, 15'000);
  EXPECT_EQ(parse_range("200:15000")->high, 15'000);
  EXPECT_EQ(parse_elevation("-20:80deg")->low, -20);
  EXPECT_EQ(parse_elevation("-20°:80°")->high, 80);
  for (std::string_view bad : {"", "200", "15m:0.2m", "-1:5", "0:inf", "1:2:3"}) EXPECT_FALSE(parse_range(bad)) << bad;
  for (std::string_view bad : {"", "80:-20", "-100:0", "0:91"}) EXPECT_FALSE(parse_elevation(bad)) << bad;
}

TEST(TrackingText, ReadsObstaclesWithOrWithoutAName) {
  const auto vice = parse_obstacle("vice=box:450,130,-500:300,30,-700");
  ASSERT_TRUE(vice);
  EXPECT_EQ(vice->name, "vice");
  EXPECT_EQ(std::get<BoxObstacle>(vice->shape).lowest_mm, (Vector3{300, 30, -700}));
  EXPECT_EQ(std::get<BoxObstacle>(vice->shape).highest_mm, (Vector3{450, 130, -500}));
  EXPECT_EQ(std::get<SphereObstacle>(parse_obstacle("sphere:1,2,3:0.04m")->shape).radius_mm, 40);
  const auto post = parse_obstacle("post=cylinder:1,2,3:4:50");
  ASSERT_TRUE(post);
  EXPECT_EQ(std::get<CylinderObstacle>(post->shape).height_mm, 50);
  for (std::string_view bad : {"", "vice", "box:1,2,3:1,5,6", "box:1,2:3,4", "sphere:1,2,3:0", "sphere:1,2,3:-1",
                               "cylinder:1,2,3:4", "cone:1,2,3:4", "box:1,2,3:4,5,6:7", "sphere:1,nan,3:4"})
    EXPECT_FALSE(parse_obstacle(bad)) << bad;
}

TEST(TrackingText, ReadsTheUncertaintyOfLengths) {
  EXPECT_DOUBLE_EQ(parse_ranging("0.3um+0.5um/m")->constant.in_um(), 0.3);
  EXPECT_DOUBLE_EQ(parse_ranging("0.3um+0.5um/m")->per_length.in_um_per_m(), 0.5);
  EXPECT_DOUBLE_EQ(parse_ranging("etalon-lasertracer")->constant.in_um(), 0.2);
  EXPECT_NEAR(parse_ranging("faro-ion:adm")->per_length.in_um_per_m(), 0.8 * 2.0 / std::sqrt(3.0), 1e-12);
  EXPECT_DOUBLE_EQ(parse_ranging("0.3um")->per_length.in_um_per_m(), 0.0);
  for (std::string_view bad : {"", "0.3", "-1um", "1um+1um+1um", "1um+-1um/m", "1um+2"})
    EXPECT_FALSE(parse_ranging(bad)) << bad;
}

TEST(TrackingText, ReadsPeriodsOfAllOrOfEach) {
  const auto all = parse_periods("10"), some = parse_periods("X=10,z=5");
  ASSERT_TRUE(all && some);
  EXPECT_EQ((*all)[1], Position::native(10));
  EXPECT_EQ((*some)[2], Position::native(5));
  EXPECT_FALSE((*some)[1]);
  for (std::string_view bad : {"", "0", "-1", "X=0", "X=1,X=2", "A=1"}) EXPECT_FALSE(parse_periods(bad)) << bad;
}

}  // namespace
}  // namespace axiometry::app
