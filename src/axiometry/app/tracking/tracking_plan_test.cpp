// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/model/aligned.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class TrackingPlanFiles : public ::testing::Test {
 protected:
  testing_support::TemporaryFolder folder_;
};

TrackingPlanRequest request(const std::string& station) {
  TrackingPlanRequest request;
  request.setup.travel = *parse_travel_box("X=0:800,Y=0:600,Z=-500:0");
  request.setup.tool_offset_mm = Vector3{0, 0, -120};
  request.setup.station = station;
  request.lines.seed = 3;
  return request;
}

TEST_F(TrackingPlanFiles, AReflectorThatNobodyChoseIsTurnedTowardsTheStation) {
  const auto planned = plan_tracking(request("100,80,-600"));
  ASSERT_TRUE(planned) << planned.error().message;
  EXPECT_EQ(planned->plan.lines.size(), 7u);
  EXPECT_THAT(planned->plan.remarks, Contains(HasSubstr("mount the reflector so that it looks along (−0.577")));
  auto chosen = request("100,80,-600");
  chosen.setup.reflector_axis = Vector3{0, 0, -1};
  EXPECT_EQ(plan_tracking(chosen)->plan.lines.size(), 4u);
}

TEST_F(TrackingPlanFiles, PointsOfTheLocationAreChosenForTheMountingThatTheLinesNeed) {
  const auto planned = plan_location_points(request("100,80,-600"), 8);
  ASSERT_TRUE(planned) << planned.error().message;
  EXPECT_EQ(planned->plan.points_mm.size(), 8u);
  EXPECT_THAT(planned->plan.remarks, Contains(HasSubstr("mount the reflector so that it looks along (−0.577")));
  EXPECT_NEAR(planned->setup.limits.reflector_axis.x, -0.577, 1e-3);
  EXPECT_FALSE(plan_location_points(request("100,80,-600"), 5));
}

TEST_F(TrackingPlanFiles, ALocatedStationComesWithItsCovariance) {
  const std::string name = folder_.written(
      "station.json", R"({"station": [100, 80, -600], "covariance": [[1e-6, 0, 0], [0, 1e-6, 0], [0, 0, 9e-6]]})");
  const auto planned = plan_tracking(request(name));
  ASSERT_TRUE(planned) << planned.error().message;
  EXPECT_TRUE(planned->plan.setup.station.covariance_mm2);
  EXPECT_THAT(planned->plan.remarks, Contains(HasSubstr("the length difference may be neglected")));
}

TEST_F(TrackingPlanFiles, WhatIsWrittenReadsBackAsTheSamePlanAndAsASetUp) {
  const auto planned = plan_tracking(request("100,80,-600"));
  ASSERT_TRUE(planned);
  OutputNames names;
  names.json = folder_.file("lines.json");
  names.reports = {folder_.file("lines.html")};
  ASSERT_TRUE(write_outputs(*planned, names, {}));
  const auto read = read_tracking_plan_file(names.json);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(formats::write_tracking_plan(*read), formats::write_tracking_plan(planned->plan));
  EXPECT_GT(whole_file(names.reports[0])->size(), 1000u);
  SetupRequest again;
  again.file = names.json;
  again.safe_radius_mm = 90;
  const auto setup = setup_of(again);
  ASSERT_TRUE(setup);
  EXPECT_EQ(setup->station.position_mm, (Vector3{100, 80, -600}));
  EXPECT_EQ(setup->limits.safe_radius_mm, 90);
}

TEST_F(TrackingPlanFiles, SuggestsWhatWouldKeepMore) {
  auto lost = request("400,-20,-665");
  lost.suggest = true;
  const auto planned = plan_tracking(lost);
  ASSERT_TRUE(planned) << planned.error().message;
  EXPECT_THAT(planned->plan.remarks, Contains(HasSubstr("(raised or lowered) would keep 7 of 7 lines")));
  lost.lines.ids = {"x"};
  const auto none = plan_tracking(lost);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("sphere below reach"));
  EXPECT_THAT(none.error().message, HasSubstr("would keep 1 of 1 lines"));
}

TEST_F(TrackingPlanFiles, SaysWhatIsMissingOrWrong) {
  const auto refusal = [](const TrackingPlanRequest& r) {
    const auto planned = plan_tracking(r);
    return planned ? std::string() : planned.error().to_string();
  };
  EXPECT_THAT(refusal({}), HasSubstr("found no travels"));
  auto r = request("");
  EXPECT_THAT(refusal(r), HasSubstr("found no station"));
  EXPECT_THAT(refusal(request("1,2,x")), HasSubstr("expected three numbers"));
  EXPECT_THAT(refusal(request("100,80")), HasSubstr("found \"100,80\", expected three numbers"));
  EXPECT_THAT(refusal(request("1,2.json")), HasSubstr("cannot open"));
  EXPECT_THAT(refusal(request(folder_.file("none.json"))), HasSubstr("cannot open"));
  EXPECT_THAT(refusal(request(folder_.written("bad.json", "{\"station\": [1, 2]}"))), HasSubstr("bad.json:1:"));
  r = request("100,80,-600");
  r.setup.file = folder_.written("setup.json", "{\"travel\": 3}");
  EXPECT_THAT(refusal(r), HasSubstr("setup.json:1:"));
  r = request("100,80,-600");
  r.lines.acceleration = -1;
  EXPECT_THAT(refusal(r), HasSubstr("found the acceleration -1"));
}

TEST(TrackingPlan, NeedsNoStationForDiagonalsAlone) {
  TrackingPlanRequest request;
  request.setup.travel = TravelBox{{0, 0, -500}, {800, 600, 0}};
  request.lines.ids = {"body", "face"};
  request.lines.seed = 3;
  const auto planned = plan_tracking(request);
  ASSERT_TRUE(planned) << planned.error().to_string();
  EXPECT_TRUE(is_aligned(planned->plan.setup));
  EXPECT_EQ(planned->plan.lines.size(), 10u);
  EXPECT_TRUE(planned->plan.lost.empty());
  EXPECT_GT(planned->duration.in_s(), 0.0);
  request.suggest = true;
  EXPECT_NE(plan_tracking(request).error().message.find("without a station"), std::string::npos);
  request.suggest = false;
  request.setup.safe_radius_mm = 100.0;
  EXPECT_NE(plan_tracking(request).error().message.find("a safe radius about the station without a station"),
            std::string::npos);
  request.setup.safe_radius_mm.reset();
  request.setup.station = "none";
  request.lines.ids = {"NNN-PPP"};
  EXPECT_EQ(plan_tracking(request)->plan.lines.size(), 1u);
  request.lines.ids = {"NNN-PPP", "x"};
  EXPECT_NE(plan_tracking(request).error().message.find("only diagonals of the travels need none"), std::string::npos);
}

}  // namespace
}  // namespace axiometry::app
