// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/plan/planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "axiometry/tracking/geometry/visibility.h"

namespace axiometry::volumetric {
namespace {

CalibrationPlan machine_to_plan() {
  CalibrationPlan plan{.machine = {.chain = *KinematicChain::make("XFYZ")}};
  plan.machine.travel = {{0, 0, -500}, {1000, 600, 0}};
  plan.machine.tools = {{"short", {0, 0, -150}}, {"long", {0, 0, -300}}, {"beside", {120, 60, -180}}};
  plan.limits.incidence_most_deg = 75.0;
  return plan;
}

const VolumetricFinding* finding(const PlannedCalibration& planned, const char* id) {
  const auto at = std::ranges::find(planned.findings, id, &VolumetricFinding::id);
  return at == planned.findings.end() ? nullptr : &*at;
}

TEST(Planner, ProposesStationsFromWhichAllErrorsAreTold) {
  const auto planned = plan_calibration(machine_to_plan(), {.points = 40});
  ASSERT_TRUE(planned) << planned.error().message;
  const auto& stations = planned->plan.machine.stations;
  ASSERT_EQ(stations.size(), 4u);
  EXPECT_EQ(planned->expected.rank.null_directions, 0u);
  EXPECT_TRUE(planned->expected.unseen.empty());
  const auto [low, high] = std::ranges::minmax(stations, {}, [](const NamedStation& s) { return s.at_mm.z; });
  EXPECT_GE(high.at_mm.z - low.at_mm.z, 50.0);
  const TravelBox room = station_room(planned->plan.machine);
  for (const NamedStation& s : stations)
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_GE(s.at_mm[a], room.lowest_mm[a] - 0.5);
      EXPECT_LE(s.at_mm[a], room.highest_mm[a] + 0.5);
    }
}

TEST(Planner, ProposesStationsThatAreBetterThanThoseThatSeeTheMost) {
  CalibrationPlan plan = machine_to_plan();
  const auto good = plan_calibration(plan, {.points = 40});
  ASSERT_TRUE(good);
  plan.machine.stations = {
      {"A", {400, 300, -900}}, {"B", {600, 300, -900}}, {"C", {500, 500, -900}}, {"D", {500, 300, -800}}};
  const auto huddled = plan_calibration(plan, {.propose_stations = false, .points = 40});
  ASSERT_TRUE(huddled);
  ASSERT_TRUE(good->expected.u_rms_um);
  EXPECT_TRUE(!huddled->expected.u_rms_um || *good->expected.u_rms_um < *huddled->expected.u_rms_um);
}

TEST(Planner, StaysWithinTheLimitsAtEveryPointAndOnEveryWay) {
  CalibrationPlan plan = machine_to_plan();
  plan.obstacles = {{"post", CylinderObstacle{{450, 280, -900}, 40, 420}}};
  const auto planned = plan_calibration(plan, {.points = 30});
  ASSERT_TRUE(planned) << planned.error().message;
  for (const PlannedRun& run : planned->plan.runs) {
    const TrackingSetup setup = setup_of(planned->plan, run.station, run.tool);
    Vector3 before = run.stops.empty() ? Vector3{} : run.stops.front().axes_mm;
    for (const PlannedStop& stop : run.stops) {
      EXPECT_FALSE(tracking::hidden_because(setup, stop.axes_mm + setup.tool_offset_mm));
      std::vector<Vector3> way = stop.over_mm;
      way.push_back(stop.axes_mm);
      for (const Vector3& next : way) {
        EXPECT_FALSE(tracking::blocked_because(setup, before + setup.tool_offset_mm, next + setup.tool_offset_mm));
        before = next;
      }
    }
  }
}

TEST(Planner, SaysWhichToolIsMissingAndWithItAllIsTold) {
  CalibrationPlan plan = machine_to_plan();
  plan.machine.tools.pop_back();
  const auto two = plan_calibration(plan, {.points = 40});
  ASSERT_TRUE(two);
  const VolumetricFinding* unseen = finding(*two, "volumetric-unseen-errors");
  ASSERT_NE(unseen, nullptr);
  EXPECT_TRUE(unseen->serious);
  EXPECT_TRUE(two->findings.front().serious);
  EXPECT_NE(unseen->message.find("ECY and ECZ"), std::string::npos) << unseen->message;
  const VolumetricFinding* advice = finding(*two, "volumetric-add-tool");
  ASSERT_NE(advice, nullptr);
  EXPECT_NE(advice->message.find("[120, 0, -225]"), std::string::npos) << advice->message;
  plan.machine.tools.push_back({"advised", {120, 0, -225}});
  const auto three = plan_calibration(plan, {.points = 40});
  ASSERT_TRUE(three);
  EXPECT_EQ(finding(*three, "volumetric-unseen-errors"), nullptr);
  EXPECT_EQ(finding(*three, "volumetric-add-tool"), nullptr);
}

TEST(Planner, TellsOfToolsAllButOnOneLineAsOfThoseOnIt) {
  CalibrationPlan plan = machine_to_plan();
  plan.machine.tools.back() = {"third", {0.03, 0, -220}};
  const auto near = plan_calibration(plan, {.points = 40});
  ASSERT_TRUE(near);
  const VolumetricFinding* unseen = finding(*near, "volumetric-unseen-errors");
  ASSERT_NE(unseen, nullptr);
  EXPECT_TRUE(unseen->serious);
  EXPECT_NE(unseen->message.find("ECY and ECZ"), std::string::npos) << unseen->message;
  EXPECT_FALSE(near->expected.errors[1 * motion_count + 5].u_mean);
  plan.machine.tools.back() = {"third", {3, 0, -220}};
  const auto close = plan_calibration(plan, {.points = 40});
  ASSERT_TRUE(close);
  ASSERT_NE(finding(*close, "volumetric-short-lever"), nullptr);
  EXPECT_TRUE(finding(*close, "volumetric-short-lever")->serious);
  const auto usual = plan_calibration(machine_to_plan(), {.points = 40});
  ASSERT_TRUE(usual);
  EXPECT_EQ(finding(*usual, "volumetric-short-lever"), nullptr);
}

TEST(Planner, TellsOfOneToolThatTwoMoreAreMissing) {
  CalibrationPlan plan = machine_to_plan();
  plan.machine.tools.resize(1);
  EXPECT_NE(tool_advice(plan.machine).find("[0, 0, -300] and [120, 0, -150]"), std::string::npos);
  EXPECT_EQ(tool_advice(machine_to_plan().machine), "");
}

TEST(Planner, TellsOfStationsThatAreFewOrAtOneHeightAndOfPointsThatAreHidden) {
  CalibrationPlan plan = machine_to_plan();
  plan.machine.stations = {{"A", {-100, -100, -850}}, {"B", {1100, 300, -850}}, {"C", {500, 700, -850}}};
  plan.limits.incidence_most_deg = 30.0;
  const auto planned = plan_calibration(plan, {.propose_stations = false, .points = 400});
  ASSERT_TRUE(planned) << planned.error().message;
  EXPECT_NE(finding(*planned, "volumetric-few-stations"), nullptr);
  EXPECT_NE(finding(*planned, "volumetric-one-height"), nullptr);
  const VolumetricFinding* few = finding(*planned, "volumetric-few-points");
  ASSERT_NE(few, nullptr);
  EXPECT_NE(few->message.find("of 400 points"), std::string::npos) << few->message;
}

TEST(Planner, FailsWithTheReasonWhereNothingIsInSight) {
  CalibrationPlan plan = machine_to_plan();
  plan.limits.range_most_mm = 250.0;
  const auto none = plan_calibration(plan, {.points = 20});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("most often in the way"), std::string::npos) << none.error().message;
  plan.machine.stations = {{"far", {90000, 0, 0}}};
  EXPECT_FALSE(plan_calibration(plan, {.propose_stations = false, .points = 20}));
  EXPECT_FALSE(plan_calibration(machine_to_plan(), {.propose_stations = false}));
  EXPECT_FALSE(plan_calibration(machine_to_plan(), {.points = 0}));
}

}  // namespace
}  // namespace axiometry::volumetric
