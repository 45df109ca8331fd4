// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lines/seven_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "axiometry/tracking/geometry/obstacles.h"
#include "axiometry/tracking/geometry/visibility.h"
#include "axiometry/tracking/lines/line_targets.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::tracking {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<std::string> all_seven(seven_lines.begin(), seven_lines.end());

/// A reach of the reflector of X 0 to 800, Y 0 to 600, Z -620 to -120; everything can be seen.
TrackingSetup machine(Vector3 station) {
  TrackingSetup setup;
  setup.travel = {{0, 0, -500}, {800, 600, 0}};
  setup.tool_offset_mm = {0, 0, -120};
  setup.station = {station, {}};
  setup.limits.elevation_highest_deg = 90.0;
  setup.limits.incidence_most_deg = 180.0;
  return setup;
}

std::vector<std::string> names(const std::vector<UsableInterval>& lines) {
  std::vector<std::string> list;
  for (const UsableInterval& line : lines) list.push_back(line.id);
  return list;
}
std::vector<std::string> names(const std::vector<LostLine>& lines) {
  std::vector<std::string> list;
  for (const LostLine& line : lines) list.push_back(line.id);
  return list;
}
LineChoice chosen(const TrackingSetup& setup, DiagonalRule rule = DiagonalRule::equal_increments) {
  return choose_lines(setup, all_seven, rule);
}
std::string reason(const LineChoice& choice, std::string_view id) {
  const auto found = std::ranges::find(choice.lost, id, &LostLine::id);
  return found == choice.lost.end() ? "" : found->reason;
}
const UsableInterval& line(const LineChoice& choice, std::string_view id) {
  static const UsableInterval absent{.id = "absent", .direction = {}, .octant = {}, .begin_mm = NAN, .end_mm = NAN};
  const auto found = std::ranges::find(choice.lines, id, &UsableInterval::id);
  if (found != choice.lines.end()) return *found;
  ADD_FAILURE() << "line " << id << " is lost: " << reason(choice, id);
  return absent;
}

// The four cases of Fig. 9.
TEST(SevenLines, InsideAllSevenCanBeMeasured) {
  const LineChoice choice = chosen(machine({100, 80, -600}));
  EXPECT_EQ(names(choice.lines), all_seven);
  EXPECT_TRUE(choice.lost.empty());
}
TEST(SevenLines, OutsideInYTheLinesThatKeepYAreLost) {
  EXPECT_THAT(names(chosen(machine({400, -12, -600})).lost), ElementsAre("x", "z", "xz"));
  EXPECT_EQ(reason(chosen(machine({400, -12, -600})), "x"),
            "the station at Y −12.0 mm is 12.0 mm outside the travel of Y: the reflector reaches 0.0 to 600.0 mm");
}
TEST(SevenLines, OutsideInXTheLinesThatKeepXAreLost) {
  EXPECT_THAT(names(chosen(machine({-30, 300, -600})).lost), ElementsAre("y", "z", "yz"));
  EXPECT_THAT(names(chosen(machine({830, 300, -600})).lost), ElementsAre("y", "z", "yz"));
}
TEST(SevenLines, OutsideInXSeenFromTheSideTheZLineIsLost) {
  const LineChoice choice = chosen(machine({-30, 300, -400}));
  EXPECT_THAT(names(choice.lost), Contains("z"));
  EXPECT_THAT(reason(choice, "z"), HasSubstr("30.0 mm outside the travel of X"));
}

TEST(SevenLines, ASphereBelowReachLosesWhatNeedsItsHeight) {
  const LineChoice choice = chosen(machine({100, 80, -665}));
  EXPECT_THAT(names(choice.lost), ElementsAre("x", "y", "xy"));
  EXPECT_EQ(reason(choice, "xy"),
            "sphere below reach: the reflector comes down to Z −620.0 mm only, the station is at Z −665.0 mm: 45.0 mm "
            "are missing; a tool longer or an instrument higher by that would help");
}

TEST(SevenLines, IntervalsAreThoseOfTheRayInTheBox) {
  const LineChoice choice = chosen(machine({100, 80, -600}));
  EXPECT_NEAR(line(choice, "x").begin_mm, 200, 1e-9);
  EXPECT_NEAR(line(choice, "x").end_mm, 700, 1e-9);
  EXPECT_EQ(line(choice, "x").octant, "+00");
  EXPECT_EQ(line(choice, "x").limited_by_begin, "least range of the instrument");
  EXPECT_EQ(line(choice, "x").limited_by_end, "upper end of X");
  EXPECT_NEAR(line(choice, "xyz").end_mm, 480 * std::sqrt(3), 1e-9);
  EXPECT_EQ(line(choice, "xyz").octant, "+++");
  EXPECT_EQ(line(choice, "xyz").limited_by_end, "upper end of Z");
  EXPECT_NEAR(line(choice, "z").end_mm, 480, 1e-9);
}

TEST(SevenLines, TheOctantIsTheOneWithTheLongestInterval) {
  const LineChoice choice = chosen(machine({700, 80, -600}));
  EXPECT_EQ(line(choice, "x").octant, "−00");
  EXPECT_EQ(line(choice, "xy").octant, "−+0");
  EXPECT_EQ(line(choice, "xyz").octant, "−++");
  EXPECT_NEAR(line(choice, "xy").end_mm, 520 * std::sqrt(2), 1e-9);
}

TEST(SevenLines, OfOctantsAlikeThatGoingUpIsTaken) {
  const LineChoice choice = chosen(machine({400, 300, -600}));
  EXPECT_EQ(line(choice, "x").octant, "+00");
  EXPECT_EQ(line(choice, "xyz").octant, "+++");
}

TEST(SevenLines, TowardsTheCornerADiagonalEndsInIt) {
  const LineChoice choice = chosen(machine({100, 80, -600}), DiagonalRule::box_corner);
  const UsableInterval& xyz = line(choice, "xyz");
  const Vector3 end = Vector3{100, 80, -600} + xyz.end_mm * xyz.direction;
  EXPECT_NEAR(distance(end, {800, 600, -120}), 0, 1e-9);
  EXPECT_NEAR(line(choice, "xy").end_mm, std::hypot(700, 520), 1e-9);
}

TEST(SevenLines, WhatTheInstrumentCannotSeeIsLostWithTheAngle) {
  TrackingSetup setup = machine({100, 80, -600});
  setup.limits.elevation_highest_deg = 80;
  EXPECT_EQ(reason(chosen(setup), "z"), "its beam has an elevation of 90.0°, the instrument takes −20.0° to 80.0°");
  setup.limits.elevation_highest_deg = 90;
  setup.limits.incidence_most_deg = 60;
  EXPECT_THAT(names(chosen(setup).lost), ElementsAre("x", "y", "xy"));
  EXPECT_THAT(reason(chosen(setup), "x"), HasSubstr("90.0° off the axis of the reflector, which takes 60.0°"));
  setup.limits.reflector_axis = {-1, -1, -1};
  EXPECT_TRUE(chosen(setup).lost.empty());
}

TEST(SevenLines, ALineTooShortSaysWhatEndsIt) {
  TrackingSetup setup = machine({400, 300, -600});
  setup.limits.range_least_mm = 320;
  EXPECT_EQ(reason(chosen(setup), "x"),
            "only 80.0 mm of it are usable, from least range of the instrument (320.0 mm from the station) to upper "
            "end of X (400.0 mm), expected 100.0 mm");
  EXPECT_THAT(reason(chosen(setup), "y"), HasSubstr("nothing of it is left between least range of the instrument"));
  setup.limits.range_most_mm = 350;
  EXPECT_THAT(reason(chosen(setup), "x"), HasSubstr("to range of the instrument (350.0 mm)"));
}

TEST(SevenLines, TheSafeRadiusBeginsALineWhereItIsLargerThanTheLeastRange) {
  TrackingSetup setup = machine({100, 80, -600});
  setup.limits.safe_radius_mm = 260;
  EXPECT_NEAR(line(chosen(setup), "x").begin_mm, 260, 1e-9);
  EXPECT_EQ(line(chosen(setup), "x").limited_by_begin, "safe radius");
}

TEST(SevenLines, AnObstacleInTheBeamEndsTheLineBeforeIt) {
  TrackingSetup setup = machine({100, 80, -600});
  setup.obstacles = {{"vice", BoxObstacle{{600, 0, -650}, {700, 160, -560}}}};
  EXPECT_NEAR(line(chosen(setup), "x").end_mm, 450, 1e-6);
  EXPECT_EQ(line(chosen(setup), "x").limited_by_end, "vice in the way");
}

TEST(SevenLines, AnObstacleBesideTheBeamLeavesTheLongerPiece) {
  TrackingSetup setup = machine({100, 80, -600});
  setup.obstacles = {{"post", CylinderObstacle{{400, 130, -700}, 20, 200}}};  // 30 mm beside, the beam passes
  const LineChoice choice = chosen(setup);
  const double half = std::sqrt(70.0 * 70.0 - 50.0 * 50.0);
  EXPECT_NEAR(line(choice, "x").begin_mm, 300 + half, 1e-6);
  EXPECT_NEAR(line(choice, "x").end_mm, 700, 1e-6);
  setup.obstacles = {{"post", CylinderObstacle{{400, 84, -700}, 1, 200}}};  // 3 mm beside: in the beam
  EXPECT_THAT(reason(chosen(setup), "x"), HasSubstr("from least range of the instrument (200.0 mm from the station) to "
                                                    "post in the way (249.2 mm)"));
  setup.limits.line_least_mm = 40;
  EXPECT_NEAR(line(chosen(setup), "x").end_mm, 300 - std::sqrt(51.0 * 51.0 - 4.0 * 4.0), 1e-6);
}

TEST(SevenLines, IntervalsAgreeWithBruteForce) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::mt19937 engine(17);
  const auto number = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967295.0;
  };
  std::size_t usable = 0;
  for (int trial = 0; trial < 60; ++trial) {
    TrackingSetup setup = machine({number(-50, 850), number(-50, 650), number(-680, -300)});
    setup.limits.incidence_most_deg = number(60, 120);
    setup.limits.reflector_axis = {number(-1, 1), number(-1, 1), number(-1, 0)};
    setup.limits.range_most_mm = number(400, 900);
    if (trial % 2 == 1) {
      const Vector3 at{number(0, 800), number(0, 600), number(-620, -200)};
      setup.obstacles = {{"box", BoxObstacle{at, at + Vector3{60, 90, 70}}},
                         {"ball", SphereObstacle{{number(0, 800), number(0, 600), number(-620, -200)}, 40}}};
    }
    const LineChoice choice = chosen(setup);
    for (const std::string& id : all_seven) {
      double longest = 0.0;
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z) {
            const std::array<int, 3> signs = {x, y, z};
            bool fits = true;
            for (std::size_t k = 0; k < 3; ++k)
              fits = fits && (signs[k] != 0) == (id.find("xyz"[k]) != std::string::npos);
            if (!fits) continue;
            const Vector3 u = unit({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
            double begin = -1.0;
            for (double d = 1.0; d < 1500.0; d += 1.0) {
              const Vector3 p = setup.station.position_mm + d * u;
              const bool good = !hidden_because(setup, p) && !blocked_because(setup, p, p);
              if (good && begin < 0.0) begin = d;
              if (!good) begin = -1.0;
              if (good) longest = std::max(longest, d - begin);
            }
          }
      const auto found = std::ranges::find(choice.lines, id, &UsableInterval::id);
      if (found != choice.lines.end()) {
        ++usable;
        EXPECT_NEAR(found->length_mm(), longest, 2.0) << trial << " " << id;
      } else {
        EXPECT_LT(longest, setup.limits.line_least_mm) << trial << " " << id << ": " << reason(choice, id);
      }
    }
  }
  EXPECT_GT(usable, 60u);
}

TEST(SevenLines, TargetsAreInTheIntervalAndOnTheGridOfCoordinates) {
  for (const DiagonalRule rule : {DiagonalRule::equal_increments, DiagonalRule::box_corner}) {
    const TrackingSetup setup = machine({100.1234, 80.4321, -600.2468});
    const auto plan = plan_lines(setup, {.rule = rule, .seed = 3});
    ASSERT_TRUE(plan) << plan.error().message;
    ASSERT_EQ(plan->lines.size(), 7u);
    for (const TrackingLine& one : plan->lines) {
      const SpatialLine way = *spatial_line(one.plan.axis);
      EXPECT_EQ(one.plan.standard, one.id.size() == 1 ? "ISO 230-2:2014" : "ISO 230-6:2002");
      for (Position target : one.plan.targets) {
        const Vector3 q = way.at(target);
        EXPECT_FALSE(hidden_because(setup, q + setup.tool_offset_mm)) << one.id;
        Vector3 off;
        for (std::size_t k = 0; k < 3; ++k) off[k] = std::round(q[k] * 1000.0) / 1000.0 - q[k];
        // Across the line only: what a program that rounds coordinates changes in the length is of second order.
        EXPECT_NEAR(dot(off, way.direction), 0.0, 1e-9) << one.id;
        EXPECT_LE(norm(off), rule == DiagonalRule::equal_increments ? 1e-9 : 0.36e-3) << one.id;
      }
      // The line passes the station within the rounding of its origin.
      const Vector3 r = setup.station.position_mm - setup.tool_offset_mm - way.origin_mm;
      EXPECT_LT(norm(r - dot(r, way.direction) * way.direction), 0.0009) << one.id;
      for (Position end : {reach(one.plan).lowest, reach(one.plan).highest})
        EXPECT_FALSE(hidden_because(setup, way.at(end) + setup.tool_offset_mm)) << one.id;
    }
  }
}

TEST(SevenLines, PositionsHaveTheirMeaning) {
  const auto plan = plan_lines(machine({700, 80, -600}), {.ids = {"x", "xy"}});
  ASSERT_TRUE(plan);
  for (const TrackingLine& one : plan->lines) {
    const SpatialLine way = *spatial_line(one.plan.axis);
    EXPECT_GT(way.direction.x, 0.0);
    EXPECT_EQ(one.plan.axis.measurement_line, "through the station at X 700.000, Y 80.000, Z −600.000 mm");
    if (one.id == "x") {
      EXPECT_EQ(way.origin_mm, (Vector3{0, 80, -480}));
      EXPECT_LT(one.plan.targets.back().in_native(), 500.0);
      EXPECT_GT(one.plan.targets.front().in_native(), 0.0);
    } else {
      EXPECT_EQ(way.origin_mm, (Vector3{700, 80, -480}));
      EXPECT_LT(one.plan.targets.back().in_native(), -200.0);
    }
  }
}

TEST(SevenLines, MovesFromLineToLineAreSafe) {
  for (const Vector3 station : {Vector3{100, 80, -600}, Vector3{400, 300, -600}, Vector3{700, 500, -580}}) {
    TrackingSetup setup = machine(station);
    setup.obstacles = {{"vice", BoxObstacle{{350, 30, -700}, {450, 130, -500}}}};
    const auto plan = plan_lines(setup, {.ids = {"x", "y", "z", "xy", "xz", "yz", "xyz", "body"}, .seed = 1});
    ASSERT_TRUE(plan) << plan.error().message;
    std::optional<Vector3> at;
    for (const TrackingLine& one : plan->lines) {
      const SpatialLine way = *spatial_line(one.plan.axis);
      std::vector<Vector3> stops = one.plan.way_in_mm;
      for (const PlannedMove& move : moves(one.plan)) stops.push_back(way.at(move.to));
      stops.insert(stops.end(), one.plan.way_out_mm.begin(), one.plan.way_out_mm.end());
      for (const Vector3& stop : stops) {
        if (at) {
          const auto why = blocked_because(setup, *at + setup.tool_offset_mm, stop + setup.tool_offset_mm);
          EXPECT_FALSE(why) << one.id << ": " << *why;
        }
        at = stop;
      }
    }
    EXPECT_EQ(plan->lines.front().plan.way_in_mm.front().z, 0.0);
    EXPECT_EQ(plan->lines.back().plan.way_out_mm.back().z, 0.0);
    EXPECT_TRUE(check_sound(plan->lines.front().plan));
  }
}

TEST(SevenLines, ALineAloneIsReachedFromAboveAndLeftThere) {
  TrackingSetup setup = machine({400, 300, -600});
  setup.obstacles = {{"vice", BoxObstacle{{350, 30, -700}, {450, 130, -500}}}};
  const auto plan = plan_lines(setup, {.seed = 1});
  ASSERT_TRUE(plan) << plan.error().message;
  for (const TrackingLine& one : plan->lines) {
    const Plan alone = plan_alone(setup, one);
    const Vector3 begin = spatial_line(one.plan.axis)->at(reach(one.plan).lowest);
    ASSERT_FALSE(alone.way_in_mm.empty()) << one.id;
    EXPECT_EQ(alone.way_in_mm.front(), (Vector3{begin.x, begin.y, 0}));
    EXPECT_EQ(alone.way_out_mm.back(), (Vector3{begin.x, begin.y, 0}));
    std::vector<Vector3> stops = alone.way_in_mm;
    stops.push_back(begin);
    stops.insert(stops.end(), alone.way_out_mm.begin(), alone.way_out_mm.end());
    for (std::size_t k = 1; k < stops.size(); ++k)
      EXPECT_FALSE(blocked_because(setup, stops[k - 1] + setup.tool_offset_mm, stops[k] + setup.tool_offset_mm))
          << one.id;
  }
  // Where there is none, the plan's own way stays.
  TrackingLine fenced = plan->lines.back();
  setup.obstacles = {{"roof", BoxObstacle{{-500, -500, -300}, {1500, 1500, -290}}}};
  EXPECT_EQ(plan_alone(setup, fenced).way_in_mm, fenced.plan.way_in_mm);
}

TEST(SevenLines, DiagonalsOfTheBoxAreFullTravels) {
  TrackingSetup setup = machine({400, 300, -900});
  const auto plan = plan_lines(setup, {.ids = {"body", "face"}});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->lines.size() + plan->lost.size(), 10u);
  const auto body = std::ranges::find(plan->lines, "NNN-PPP", &TrackingLine::id);
  ASSERT_NE(body, plan->lines.end());
  EXPECT_NEAR(body->plan.axis.travel_end->in_native(), std::sqrt(800.0 * 800 + 600.0 * 600 + 500.0 * 500), 1e-6);
  EXPECT_THAT(plan->remarks, Contains(HasSubstr("needs an interferometer aligned with it")));
}

TEST(SevenLines, AStationInTheWayLosesADiagonalOfTheBox) {
  const auto plan = plan_lines(machine({400, 300, -370}), {.ids = {"body", "x"}});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->lines.size(), 1u);
  EXPECT_THAT(plan->lost.front().reason, HasSubstr("within its safe radius"));
}

TEST(SevenLines, APeriodAlongADiagonalIsThatOfTheSlowestAxis) {
  const double root = std::sqrt(2.0);
  const auto mm = [](double x) { return std::optional(Position::native(x)); };
  EXPECT_NEAR(period_along({1 / root, -1 / root, 0}, {mm(10), mm(5), mm(100)})->in_native(), 10 * root, 1e-12);
  EXPECT_FALSE(period_along({1, 0, 0}, {std::nullopt, mm(5), mm(5)}));
}

TEST(SevenLines, ALongLineIsMeasuredFiveTimesWithFiveTargetsPerMetre) {
  TrackingSetup setup = machine({100, 80, -600});
  setup.travel.highest_mm.x = 4000;
  const auto plan = plan_lines(setup, {.ids = {"x"}});
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->lines[0].plan.runs, 5u);
  EXPECT_GE(plan->lines[0].plan.targets.size(), 18u);
  EXPECT_TRUE(plan->lines[0].plan.further.empty());
  EXPECT_THAT(plan->remarks, Contains(HasSubstr("above 2 000 mm")));
}

TEST(SevenLines, TheSameRequestGivesTheSamePlanAndAnotherSeedOtherTargets) {
  const TrackingSetup setup = machine({100, 80, -600});
  const auto a = plan_lines(setup, {.seed = 3}), b = plan_lines(setup, {.seed = 3}), c = plan_lines(setup, {.seed = 4});
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(a->lines[2].plan.targets, b->lines[2].plan.targets);
  EXPECT_NE(a->lines[2].plan.targets, c->lines[2].plan.targets);
}

TEST(SevenLines, SaysFromWhereTheLengthDifferenceMayBeNeglected) {
  TrackingSetup setup = machine({100, 80, -600});
  setup.station.covariance_mm2 = Matrix3{{{1e-4, 0, 0}, {0, 1e-4, 0}, {0, 0, 1e-4}}};
  const auto plan = plan_lines(setup, {.ids = {"x"}});
  ASSERT_TRUE(plan);
  EXPECT_THAT(plan->remarks, Contains(HasSubstr("x: the length difference may be neglected")));
}

TEST(SevenLines, RefusesWhatCannotBePlanned) {
  const auto refusal = [](const TrackingSetup& setup, const LinesRequest& request = {}) {
    const auto plan = plan_lines(setup, request);
    return plan ? std::string() : plan.error().message;
  };
  TrackingSetup setup = machine({100, 80, -600});
  EXPECT_THAT(refusal(setup, {.ids = {"xq"}}), HasSubstr("found the line \"xq\", expected x, y"));
  EXPECT_THAT(refusal(setup, {.feed = -1}), HasSubstr("found the feed -1"));
  EXPECT_THAT(refusal(setup, {.step_mm = 0}), HasSubstr("found a step of 0 mm"));
  setup.travel.highest_mm.y = 0;
  EXPECT_THAT(refusal(setup), HasSubstr("found the travel of Y 0 to 0 mm"));
  EXPECT_THAT(refusal(machine({100'000, 80, -600})), HasSubstr("are its coordinates in mm"));
  EXPECT_THAT(refusal(machine({std::numeric_limits<double>::quiet_NaN(), 80, -600})), HasSubstr("finite"));
  EXPECT_THAT(refusal(machine({-100, -100, -700}), {.ids = {"x"}}), HasSubstr("sphere below reach"));
  setup = machine({100, 80, -600});
  setup.limits.range_least_mm = 20'000;
  EXPECT_THAT(refusal(setup), HasSubstr("found a range in mm of 20000 to 15000"));
  setup = machine({100, 80, -600});
  setup.obstacles = {{"flat", BoxObstacle{{0, 0, 0}, {1, 1, 0}}}};
  EXPECT_THAT(refusal(setup), HasSubstr("\"flat\" without extent"));
  setup.obstacles = {{"table", BoxObstacle{{0, 0, -800}, {800, 600, -590}}}};
  EXPECT_THAT(refusal(setup), HasSubstr("found the station 0.0 mm from the obstacle \"table\""));
}

TEST(SevenLines, SuggestsAStationThatKeepsMore) {
  TrackingSetup setup = machine({-30, 300, -600});
  const StationSuggestion better = suggest_station(setup, all_seven, DiagonalRule::equal_increments);
  EXPECT_EQ(better.lines, 7u);
  EXPECT_EQ(better.position_mm.z, -600.0);
  setup.station.position_mm = better.position_mm;
  const LineChoice choice = chosen(setup);
  ASSERT_EQ(choice.lines.size(), 7u);
  double shortest = 1e9;
  for (const UsableInterval& one : choice.lines) shortest = std::min(shortest, one.length_mm());
  EXPECT_NEAR(shortest, better.shortest_mm, 1e-9);
  // No place on a grid of its own is better by more than what the last steps of the search leave.
  for (double x = 10; x <= 790; x += 20)
    for (double y = 10; y <= 590; y += 20) {
      setup.station.position_mm = {x, y, -600};
      const LineChoice other = chosen(setup);
      if (other.lines.size() < 7) continue;
      double least = 1e9;
      for (const UsableInterval& one : other.lines) least = std::min(least, one.length_mm());
      EXPECT_LT(least, better.shortest_mm + 2.0) << x << " " << y;
    }
}

TEST(SevenLines, ASuggestionRaisesASphereBelowReachOnlyWhereItMay) {
  const TrackingSetup setup = machine({100, 80, -700});
  EXPECT_EQ(suggest_station(setup, all_seven, DiagonalRule::equal_increments).lines, 4u);
  const auto raised =
      suggest_station(setup, all_seven, DiagonalRule::equal_increments, {.may_move = {true, true, true}});
  EXPECT_EQ(raised.lines, 7u);
  EXPECT_GT(raised.position_mm.z, -620.0);
}

TEST(SevenLines, ASuggestionMayTurnTheReflector) {
  TrackingSetup setup = machine({100, 80, -600});
  setup.limits.incidence_most_deg = 60;
  EXPECT_EQ(suggest_station(setup, all_seven, DiagonalRule::equal_increments).lines, 4u);
  const auto turned = suggest_station(setup, all_seven, DiagonalRule::equal_increments, {.turn_reflector = true});
  EXPECT_EQ(turned.lines, 7u);
  EXPECT_LT(turned.reflector_axis.z, 0.0);
}

}  // namespace
}  // namespace axiometry::tracking
