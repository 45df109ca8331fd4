// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/tracked_machine.h"

#include <gtest/gtest.h>

#include <cmath>

namespace axiometry::simulation {
namespace {

const std::vector<Vector3> points = {{0, 0, 100}, {900, 0, 150}, {900, 500, 300}, {0, 500, 450}, {450, 250, 700}};
constexpr Vector3 station = {400, 200, -50};

TrackingPlan plan_of_lines() {
  TrackingPlan plan;
  plan.setup.tool_offset_mm = {0, 0, -100};
  plan.setup.station.position_mm = station;
  for (const auto& [id, direction] :
       {std::pair<const char*, Vector3>{"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"xyz", {1, 1, 1}}}) {
    TrackingLine line{.id = id, .plan = {}};
    line.plan.axis.name = id;
    // Positions count from the station.
    set_spatial_line(line.plan.axis, {station - plan.setup.tool_offset_mm, unit(direction)});
    for (const double d : {250.0, 300.0, 350.0, 400.0}) line.plan.targets.push_back(Position::native(d));
    line.plan.runs = 2;
    line.plan.overrun = Position::native(5);
    line.plan.feed = 3000;
    line.plan.dwell = Duration::s(2);
    line.plan.way_in_mm = {station + Vector3{300, 0, 600}};
    plan.lines.push_back(line);
  }
  return plan;
}

TEST(TrackedMachine, ThatIsPerfectShowsTheDistances) {
  const VirtualTracker tracker{.station_mm = station};
  const auto location = simulate_location({}, tracker, points, {.tool_offset_mm = {3, 4, 5}}, 1);
  ASSERT_TRUE(location) << location.error().message;
  EXPECT_EQ(location->points.front().length_difference_mm, 0.0);
  EXPECT_NEAR(location->dead_path_mm, distance(points[0], station), 1e-12);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(location->points[k].at_mm, points[k]);
    EXPECT_NEAR(location->points[k].length_difference_mm, distance(points[k], station) - location->dead_path_mm, 1e-12);
  }
}

TEST(TrackedMachine, IsDisplacedAsTheSignsOfSquarenessSay) {
  TrackedMachine machine;
  machine.origin_mm = {10, 20, 30};
  machine.C0Y = RelativeLength::um_per_m(100);
  EXPECT_NEAR(displacement_mm(machine, {10, 1020, 30}, {}).x, -0.1, 1e-15);
  machine = {.origin_mm = {10, 20, 30}, .B0Z = RelativeLength::um_per_m(100)};
  EXPECT_NEAR(displacement_mm(machine, {10, 20, 1030}, {}).x, 0.1, 1e-15);
  machine = {.origin_mm = {10, 20, 30}, .A0Z = RelativeLength::um_per_m(100)};
  EXPECT_NEAR(displacement_mm(machine, {10, 20, 1030}, {}).y, -0.1, 1e-15);
  machine = {.origin_mm = {10, 20, 30}};
  machine.scale[2] = RelativeLength::um_per_m(50);
  EXPECT_NEAR(displacement_mm(machine, {500, 600, 230}, {}).z, 0.01, 1e-15);
  machine = {.waves = {{.displaced = 1, .moved = 0, .amplitude = Length::um(3), .period_mm = 40}}};
  EXPECT_NEAR(displacement_mm(machine, {10, 0, 0}, {}).y, 0.003, 1e-15);
}

TEST(TrackedMachine, WarmsAndGrowsWithTime) {
  TrackedMachine machine;
  machine.growth[2] = Length::um(20);
  machine.warming[0] = RelativeLength::um_per_m(10);
  machine.growth_time = Duration::s(1000);
  EXPECT_EQ(displacement_mm(machine, {500, 0, 0}, Duration::s(0)).z, 0.0);
  const Vector3 later = displacement_mm(machine, {500, 0, 0}, Duration::s(1000));
  EXPECT_NEAR(later.z, 0.020 * (1 - std::exp(-1)), 1e-15);
  EXPECT_NEAR(later.x, 0.005 * (1 - std::exp(-1)), 1e-15);
}

TEST(TrackedMachine, StretchesItsLinesAsItSays) {
  TrackedMachine machine;
  machine.scale = {RelativeLength::um_per_m(20), RelativeLength::um_per_m(-30), RelativeLength::um_per_m(10)};
  machine.C0Y = RelativeLength::um_per_m(15);
  machine.B0Z = RelativeLength::um_per_m(-25);
  machine.A0Z = RelativeLength::um_per_m(40);
  const VirtualTracker tracker{.station_mm = station + displacement_mm(machine, station - Vector3{0, 0, -100}, {})};
  const TrackingPlan plan = plan_of_lines();
  const auto lengths = simulate_lengths(machine, tracker, plan, {}, 1);
  ASSERT_TRUE(lengths);
  EXPECT_EQ(lengths->readings.size(), 3u * 16u);
  for (const TrackingLine& line : plan.lines) {
    double low = 0, high = 0;
    for (const LengthReading& r : lengths->readings) {
      if (r.line != line.id || r.approach.run != 0 || r.approach.direction != Direction::up) continue;
      if (r.approach.target == 0) low = r.length_difference_mm;
      if (r.approach.target == 3) high = r.length_difference_mm;
    }
    EXPECT_NEAR(((high - low) / 150.0 - 1.0) * 1e6,
                stretch(machine, spatial_line(line.plan.axis)->direction).in_um_per_m(), 2e-3)
        << line.id;
  }
}

TEST(TrackedMachine, HasPlayBetweenTheDirections) {
  TrackedMachine machine;
  machine.backlash[0] = Length::um(8);
  const VirtualTracker tracker{.station_mm = station};
  const auto lengths = simulate_lengths(machine, tracker, plan_of_lines(), {}, 1);
  ASSERT_TRUE(lengths);
  const auto at = [&](std::size_t target, Direction direction) {
    for (const LengthReading& r : lengths->readings)
      if (r.line == "x" && r.approach == Approach{target, direction, 1}) return r.length_difference_mm;
    return std::nan("");
  };
  EXPECT_NEAR(at(1, Direction::up) - at(1, Direction::down), -0.008, 1e-12);
}

TEST(TrackedMachine, ScattersAsMuchAsItIsTold) {
  const std::vector<Vector3> many(4000, Vector3{900, 200, -50});
  const VirtualTracker tracker{
      .station_mm = station, .noise = Length::um(0.5), .noise_per_length = RelativeLength::um_per_m(1.0)};
  TrackedMachine machine;
  machine.repeatability[0] = Length::um(2);
  machine.repeatability[1] = Length::um(50);  // across the beam
  const auto location = simulate_location(machine, tracker, many, {}, 3);
  ASSERT_TRUE(location);
  double shown = 0, truth = 0, across = 0;
  for (const TrueLength& t : location->truth) {
    truth += std::pow(t.reflector_mm.x - 900, 2);
    across += std::pow(t.reflector_mm.y - 200, 2);
    shown += std::pow(t.shown_mm - (t.distance_mm - location->dead_path_mm), 2);
  }
  EXPECT_NEAR(std::sqrt(truth / 4000) * 1e3, 2.0, 0.1);
  EXPECT_NEAR(std::sqrt(across / 4000) * 1e3, 50.0, 2.5);
  EXPECT_NEAR(std::sqrt(shown / 4000) * 1e3, 1.0, 0.05) << "0.5 µm + 1 µm/m · 0.5 m";
}

TEST(TrackedMachine, JumpsWhereTheBeamIsBroken) {
  const TrackingPlan plan = plan_of_lines();
  VirtualTracker tracker{.station_mm = station};
  const auto whole = simulate_lengths({}, tracker, plan, {}, 1);
  tracker.breaks = {{20, 3.25, false}, {40, -1.0, true}};
  const auto broken = simulate_lengths({}, tracker, plan, {}, 1);
  ASSERT_TRUE(whole && broken);
  for (std::size_t k = 0; k < whole->readings.size(); ++k) {
    EXPECT_NEAR(broken->readings[k].length_difference_mm - whole->readings[k].length_difference_mm,
                k < 20   ? 0.0
                : k < 40 ? 3.25
                         : 2.25,
                1e-12);
    EXPECT_EQ(broken->readings[k].segment, k < 40 ? 0u : 1u);
  }
  tracker.breaks = {{48, 1.0, false}};
  EXPECT_FALSE(simulate_lengths({}, tracker, plan, {}, 1)) << "there are 48 readings";
}

TEST(TrackedMachine, RoundsToTheResolutionAndShowsTheScaleOfTheAir) {
  const VirtualTracker tracker{.station_mm = station,
                               .dead_path_mm = 100.0,
                               .scale_error = RelativeLength::um_per_m(1000),
                               .resolution = Length::um(0.1)};
  const auto location = simulate_location({}, tracker, std::vector<Vector3>{{400, 200, 250}}, {}, 1);
  ASSERT_TRUE(location);
  EXPECT_EQ(location->points[0].length_difference_mm, 200.2);
  const auto ranges =
      simulate_ranges({}, tracker, std::vector<Vector3>{station}, std::vector<Vector3>{{400, 200, 250}}, {}, 1);
  ASSERT_TRUE(ranges);
  EXPECT_EQ(ranges->readings[0].length_mm, 200.3) << "κ L − L_0, eq. 2";
}

TEST(TrackedMachine, GivesTheSameBitsForASeedAndOthersForAnother) {
  const VirtualTracker tracker{.station_mm = station, .noise = Length::um(1)};
  const auto once = simulate_location({}, tracker, points, {}, 7),
             twice = simulate_location({}, tracker, points, {}, 7),
             other = simulate_location({}, tracker, points, {}, 8);
  EXPECT_EQ(once->points[3].length_difference_mm, twice->points[3].length_difference_mm);
  EXPECT_NE(once->points[3].length_difference_mm, other->points[3].length_difference_mm);
  // Regression: the bits must not change with compiler or system.
  const auto one = simulate_location({}, tracker, std::vector<Vector3>{{400, 200, 250}}, {}, 7);
  EXPECT_EQ(one->points[0].length_difference_mm, -0x1.370bec75cb6b2p-16);
}

TEST(TrackedMachine, ThatCannotBeIsRefusedWithWhatWasFound) {
  TrackedMachine machine;
  machine.scale[1] = RelativeLength::um_per_m(std::nan(""));
  EXPECT_FALSE(check_sound(machine));
  machine = {};
  machine.waves = {{.displaced = 0, .moved = 0, .amplitude = Length::um(1), .period_mm = 0}};
  EXPECT_EQ(check_sound(machine).error().message, "found a sinusoid of the period 0 mm, expected one above 0");
  machine = {};
  machine.repeatability[2] = Length::um(-1);
  EXPECT_EQ(check_sound(machine).error().message, "found the repeatability of Z of -0.001 mm, expected 0 to 10000 mm");
  VirtualTracker tracker{.station_mm = {0, 1e7, 0}};
  EXPECT_FALSE(simulate_location({}, tracker, points, {}, 1));
  tracker = {.breaks = {{5, 1, false}, {5, 1, false}}};
  EXPECT_FALSE(check_sound(tracker));
  EXPECT_FALSE(simulate_location({}, {}, {}, {}, 1));
  EXPECT_FALSE(simulate_lengths({}, {}, {}, {}, 1));
  TrackingPlan plan = plan_of_lines();
  plan.lines[1].plan.axis.line_direction = {};
  EXPECT_EQ(simulate_lengths({}, {}, plan, {}, 1).error().message,
            "the line \"y\": found an invalid line in space, expected three finite numbers for its origin and for "
            "its direction, not all zero, of a linear axis");
  plan.lines[1].plan.axis.line_origin_mm = {};
  plan.lines[1].plan.way_in_mm = {};
  EXPECT_EQ(simulate_lengths({}, {}, plan, {}, 1).error().message,
            "the line \"y\": found no place in space, expected its origin and direction");
}

}  // namespace
}  // namespace axiometry::simulation
