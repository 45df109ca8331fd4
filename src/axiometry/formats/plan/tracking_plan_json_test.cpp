// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/plan/tracking_plan_json.h"

#include <gtest/gtest.h>

#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/model/aligned.h"

namespace axiometry::formats {
namespace {

Plan a_plan(std::string name, Vector3 direction) {
  Plan plan;
  plan.axis.name = std::move(name);
  set_spatial_line(plan.axis, {{100.0, 200.0, -300.25}, unit(direction)});
  plan.targets = {Position::native(200.0), Position::native(310.5), Position::native(1.0 / 3.0 + 400.0)};
  plan.overrun = Position::native(5.0);
  plan.feed = 1000.0;
  plan.dwell = Duration::s(3.0);
  return plan;
}

TrackingPlan whole() {
  TrackingPlan plan;
  plan.title = "Seven lines";
  plan.machine = "Mill 4";
  plan.date = "2026-11-22";
  plan.setup.travel = {{0.0, 0.0, -500.0}, {800.0, 500.0, 0.0}};
  plan.setup.tool_offset_mm = {0.0, 0.5, -120.0};
  plan.setup.station = {{400.0, 250.0, -450.0}, Matrix3{{{1e-6, 2e-8, 0.0}, {2e-8, 2e-6, -1e-8}, {0.0, -1e-8, 4e-6}}}};
  plan.setup.limits.range_least_mm = 150.0;
  plan.setup.ranging.constant = Length::um(0.4);
  plan.setup.obstacles = {{"vice", BoxObstacle{{0.0, 0.0, -500.0}, {100.0, 100.0, -400.0}}},
                          {"", SphereObstacle{{1.0, 2.0, 3.0}, 4.0}},
                          {"probe", CylinderObstacle{{5.0, 6.0, 7.0}, 8.0, 9.0}}};
  plan.lines = {{"x", a_plan("X", {1.0, 0.0, 0.0})}, {"xyz", a_plan("XYZ", {1.0, -1.0, 1.0})}};
  plan.lost = {{"z", "the sphere is below reach"}};
  plan.remarks = {"a remark"};
  return plan;
}

std::string whole_with(std::string_view what, std::string_view with) {
  std::string text = write_tracking_plan(whole());
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

std::string tracking_plan_error(const std::string& text) {
  const auto plan = read_tracking_plan(text);
  return plan ? "" : plan.error().to_string();
}

TEST(TrackingPlanJson, IsReadAsItWasWritten) {
  const std::string text = write_tracking_plan(whole());
  const auto again = read_tracking_plan(text);
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(write_tracking_plan(*again), text);
  EXPECT_EQ(again->setup.station.position_mm, whole().setup.station.position_mm);
  EXPECT_EQ(again->setup.station.covariance_mm2, whole().setup.station.covariance_mm2);
  EXPECT_EQ(again->setup.limits.range_least_mm, 150.0);
  EXPECT_EQ(again->setup.ranging.constant, Length::um(0.4));
  ASSERT_EQ(again->setup.obstacles.size(), 3u);
  EXPECT_EQ(std::get<CylinderObstacle>(again->setup.obstacles[2].shape).height_mm, 9.0);
  ASSERT_EQ(again->lines.size(), 2u);
  EXPECT_EQ(again->lines[1].plan.targets, whole().lines[1].plan.targets);
  EXPECT_EQ(again->lost[0].reason, "the sphere is below reach");
}

TEST(TrackingPlanJson, IsToldFromAPlanOfOneAxis) {
  EXPECT_TRUE(is_tracking_plan(write_tracking_plan(whole())));
  EXPECT_FALSE(is_tracking_plan(write_plan(whole().lines[0].plan)));
  EXPECT_FALSE(is_tracking_plan("x,y,z"));
  EXPECT_FALSE(is_tracking_plan(""));
}

TEST(TrackingPlanJson, OfAnAlignedInterferometerHasNeitherStationNorLimits) {
  TrackingPlan plan = whole();
  plan.setup.station = no_station();
  EXPECT_NE(tracking_plan_error(write_tracking_plan(plan)).find("in a plan without a station, expected diagonals"),
            std::string::npos);
  plan.lines[0] = {"NN0-PP0", a_plan("NN0-PP0", {1.0, 1.0, 0.0})};
  plan.lines[1] = {"NPN-PNP", a_plan("NPN-PNP", {1.0, -1.0, 1.0})};
  const std::string text = write_tracking_plan(plan);
  EXPECT_EQ(text.find("\"station\""), std::string::npos);
  EXPECT_EQ(text.find("\"limits\""), std::string::npos);
  const auto read = read_tracking_plan(text);
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_TRUE(is_aligned(read->setup));
  EXPECT_EQ(write_tracking_plan(*read), text);
}

TEST(TrackingPlanJson, RefusesWhatIsNoneWithItsPlace) {
  EXPECT_NE(tracking_plan_error(whole_with("\"id\": \"xyz\"", "\"id\": \"x\"")).find("the line \"x\" a second time"),
            std::string::npos);
  EXPECT_NE(tracking_plan_error(whole_with("\"station\"", "\"statoin\"")).find("perhaps \"station\""),
            std::string::npos);
  EXPECT_NE(tracking_plan_error(whole_with("\"travel\"", "\"travle\"")).find("no member \"travel\""),
            std::string::npos);
  EXPECT_NE(tracking_plan_error(whole_with("\"obstacles\"", "\"obstacle\"")).find("perhaps \"obstacles\""),
            std::string::npos);
  EXPECT_NE(
      tracking_plan_error(whole_with("\"range_least_mm\": 150", "\"range_least_mm\": 99999")).find("a range of 99999"),
      std::string::npos);
  EXPECT_NE(tracking_plan_error(whole_with("\"radius_mm\": 4", "\"radius_mm\": -4")).find("a radius of -4"),
            std::string::npos);
  EXPECT_NE(tracking_plan_error(whole_with("\"constant_um\": 0.4", "\"constant_um\": -1")).find("-1 µm"),
            std::string::npos);
  EXPECT_NE(tracking_plan_error(whole_with("\"2026-11-22\"", "\"2026-02-30\"")).find("the date of the plan"),
            std::string::npos);
  const std::string place = tracking_plan_error(whole_with("\"lost\": [", "\"lost\": [3, "));
  EXPECT_NE(place.find("\"lost\" of the kind number"), std::string::npos) << place;
  EXPECT_GT(read_tracking_plan(whole_with("\"lost\": [", "\"lost\": [3, ")).error().at.line, 10u);
}

TEST(TrackingPlanJson, RefusesACovarianceThatNothingHas) {
  TrackingPlan plan = whole();
  auto& m = *plan.setup.station.covariance_mm2;
  m[0][1] = 0.5;
  EXPECT_NE(tracking_plan_error(write_tracking_plan(plan)).find("symmetric"), std::string::npos);
  m[1][0] = 0.5;
  EXPECT_NE(tracking_plan_error(write_tracking_plan(plan)).find("such variances"), std::string::npos);
  m[0][1] = m[1][0] = 0.0;
  m[2][2] = -1.0;
  EXPECT_NE(tracking_plan_error(write_tracking_plan(plan)).find("the variance -1 of Z"), std::string::npos);
}

TEST(TrackingPlanJson, RefusesTheNameOfADiagonalThatGoesAnotherWay) {
  TrackingPlan plan = whole();
  for (const char* id : {"NNN-PPP", "NP0-PN0", "PNP-NPN"}) {
    plan.lines[1].id = id;
    EXPECT_NE(tracking_plan_error(write_tracking_plan(plan)).find("with the direction of \"NPN-PNP\""),
              std::string::npos)
        << id;
  }
  plan.lines[1].id = "NPN-PNP";
  EXPECT_EQ(tracking_plan_error(write_tracking_plan(plan)), "");
}

TEST(TrackingPlanJson, NeedsALineInSpaceOfEachLine) {
  TrackingPlan plan = whole();
  plan.lines[0].plan.axis.line_origin_mm.clear();
  plan.lines[0].plan.axis.line_direction.clear();
  EXPECT_NE(tracking_plan_error(write_tracking_plan(plan)).find("without line_origin_mm"), std::string::npos);
}

}  // namespace
}  // namespace axiometry::formats
