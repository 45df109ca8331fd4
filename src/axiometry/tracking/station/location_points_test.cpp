// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/location_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "axiometry/tracking/geometry/visibility.h"
#include "axiometry/tracking/station/station.h"

namespace axiometry::tracking {
namespace {

TrackingSetup setup() {
  TrackingSetup s;
  s.travel = {{0, 0, 0}, {1000, 600, 500}};
  s.tool_offset_mm = {0, 0, -150};
  s.station.position_mm = {480, 310, -250};
  return s;
}

TEST(LocationPoints, TheyCanBeReachedAndSeenAndFindTheStation) {
  const auto plan = plan_location(setup(), 6);
  ASSERT_TRUE(plan) << plan.error().to_string();
  ASSERT_EQ(plan->points_mm.size(), 6);
  std::vector<LocationPoint> points;
  for (Vector3 p : plan->points_mm) {
    EXPECT_FALSE(hidden_because(setup(), p));
    EXPECT_FALSE(blocked_because(setup(), p, p));
    points.push_back({p, distance(p, setup().station.position_mm) - 300.0});
  }
  EXPECT_LT(plan->quality.amplification.x, 2.5);
  EXPECT_LT(plan->quality.amplification.y, 2.5);
  EXPECT_LT(plan->quality.amplification.z, 5.0);
  EXPECT_LT(plan->quality.condition_linear, 300.0);
  EXPECT_TRUE(plan->remarks.empty()) << plan->remarks.front();
  const auto location = locate_station(points, {});
  ASSERT_TRUE(location) << location.error().to_string();
  EXPECT_NEAR(distance(location->refined.station_mm, setup().station.position_mm), 0.0, 1e-8);
  EXPECT_EQ(location->surface, CriticalSurface::none);
  // the quality that was promised is that which is found
  EXPECT_NEAR(location->refined.covariance_stated_mm2[2][2] / plan->quality.covariance_mm2[2][2], 1.0, 1e-6);
  EXPECT_NEAR(location->linear->condition / plan->quality.condition_linear, 1.0, 1e-6);
}

TEST(LocationPoints, TheSameRequestGivesTheSamePointsAndMorePointsAreBetter) {
  const auto a = plan_location(setup(), 6), b = plan_location(setup(), 6), c = plan_location(setup(), 12);
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(a->points_mm, b->points_mm);
  EXPECT_LT(c->quality.amplification.z, a->quality.amplification.z);
}

TEST(LocationPoints, TravelsWithoutThirdDirectionAreSaidToBeCritical) {
  TrackingSetup flat = setup();
  flat.travel.highest_mm.z = flat.travel.lowest_mm.z = 200;
  const auto plan = plan_location(flat, 6);
  ASSERT_TRUE(plan) << plan.error().to_string();
  ASSERT_FALSE(plan->remarks.empty());
  EXPECT_NE(plan->remarks.back().find("critical surface"), std::string::npos);
}

TEST(LocationPoints, WhatCannotBeIsRefusedWithItsReason) {
  EXPECT_EQ(plan_location(setup(), 5).error().message, "found 5 points for the station location, expected 6 to 50");
  TrackingSetup far = setup();
  far.station.position_mm = {480, 310, -25'000};
  const auto refused = plan_location(far, 6);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("found 0 of 2197 places"), std::string::npos) << refused.error().message;
  EXPECT_NE(refused.error().message.find("range"), std::string::npos) << refused.error().message;
  TrackingSetup backwards = setup();
  backwards.travel.highest_mm.y = -1;
  EXPECT_NE(plan_location(backwards, 6).error().message.find("of Y"), std::string::npos);
  TrackingSetup nowhere = setup();
  nowhere.station.position_mm.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(plan_location(nowhere, 6));
}

}  // namespace
}  // namespace axiometry::tracking
