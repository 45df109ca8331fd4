// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/simulate/simulated_lengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "axiometry/volumetric/identify/identification.h"

namespace axiometry::volumetric {
namespace {

MachineModel simulated_machine(const char* chain = "XFYZ") {
  MachineModel machine{.chain = *KinematicChain::make(chain)};
  machine.travel = {{0, 0, -500}, {1000, 600, 0}};
  machine.tools = {{"short", {0, 0, -150}}, {"long", {0, 0, -300}}, {"beside", {120, 60, -180}}};
  machine.stations = {
      {"S1", {-150, -120, -700}}, {"S2", {1150, -100, -650}}, {"S3", {500, 720, -680}}, {"S4", {200, 300, -900}}};
  return machine;
}

TrueCurve table(std::vector<TrueCurve::Node> nodes) { return *TrueCurve::make(std::move(nodes)); }

TEST(TrueCurve, GoesThroughItsTableAndIsACubicBetween) {
  std::vector<TrueCurve::Node> nodes;
  const auto cubic = [](double q) { return 1.0 - 0.02 * q + 3e-4 * q * q - 2e-6 * q * q * q; };
  for (const double q : {0.0, 7.0, 30.0, 55.0, 80.0, 100.0}) nodes.push_back({q, cubic(q)});
  const TrueCurve curve = table(nodes);
  for (const double q : {-4.0, 0.0, 3.0, 29.9, 55.0, 77.7, 100.0, 105.0})
    EXPECT_NEAR(curve.at(q), cubic(q), 1e-12) << q;
  EXPECT_DOUBLE_EQ(table({{0.0, 1.0}, {10.0, 3.0}}).at(2.5), 1.5);
}

TEST(TrueCurve, LosesItsBestLineAndNothingElse) {
  const TrueCurve curve = table({{0, 3}, {40, -2}, {90, 5}, {130, 4}, {200, -7}});
  const TrueCurve::Line line = curve.line(0.0, 200.0);
  const TrueCurve left = curve.less(line, 0.0, 200.0);
  EXPECT_NEAR(left.line(0.0, 200.0).mean, 0.0, 1e-12);
  EXPECT_NEAR(left.line(0.0, 200.0).slope_per_mm, 0.0, 1e-14);
  for (const double q : {10.0, 100.0, 177.0})
    EXPECT_NEAR(left.at(q), curve.at(q) - line.mean - line.slope_per_mm * (q - 100.0), 1e-12);
}

TEST(TrueCurve, RefusesTablesThatAreNone) {
  EXPECT_FALSE(TrueCurve::make({{0.0, 1.0}}));
  EXPECT_FALSE(TrueCurve::make({{0.0, 1.0}, {0.0, 2.0}}));
  EXPECT_FALSE(TrueCurve::make({{0.0, 1.0}, {1.0, std::nan("")}}));
}

/// What the gauge takes off: one place of each tool and one rotation of the whole.
struct Rigid {
  std::array<Vector3, 3> constants;
  Vector3 rotation_urad;
};

/// From the differences at 4 places with the first tool and at one with each other.
Rigid rigid_of(const MachineModel& machine, const TrueErrors& raw, const TrueErrors& gauged) {
  const auto difference = [&](Vector3 q, std::size_t tool) {
    const Vector3 t = machine.tools[tool].offset_mm;
    return displacement_um(machine, raw.at(q), q, t) - displacement_um(machine, gauged.at(q), q, t);
  };
  const Vector3 at = difference({}, 0);
  const Vector3 x = 1e-3 * (difference({1000, 0, 0}, 0) - at), y = 1e-3 * (difference({0, 1000, 0}, 0) - at);
  Rigid rigid{{}, 1000.0 * Vector3{y.z, -x.z, x.y}};
  for (std::size_t k = 0; k < 3; ++k) rigid.constants[k] = difference({}, k);
  return rigid;
}

TEST(TrueErrors, InTheGaugeMoveTheWholeAndNothingInIt) {
  for (const char* chain : {"XFYZ", "FXYZ", "YXFZ", "FZYX", "XYZF", "ZFXY"}) {
    const MachineModel machine = simulated_machine(chain);
    const TrueErrors raw = drawn_errors(machine.travel, {}, {.seed = 5});
    const TrueErrors gauged = in_gauge(raw, machine);
    const Rigid rigid = rigid_of(machine, raw, gauged);
    for (const Visit& visit : spread_visits(machine, 20, {.seed = 3})) {
      const Vector3 t = machine.tools[visit.tool].offset_mm, q = visit.axes_mm;
      const Vector3 difference =
          displacement_um(machine, raw.at(q), q, t) - displacement_um(machine, gauged.at(q), q, t);
      const Vector3 expected = rigid.constants[visit.tool] + 1e-3 * cross(rigid.rotation_urad, q);
      EXPECT_LT(distance(difference, expected), 1e-9) << chain;
    }
  }
}

TEST(TrueErrors, StayAsTheyAreInTheGaugeASecondTime) {
  const MachineModel machine = simulated_machine("YXFZ");
  const TrueErrors once = in_gauge(drawn_errors(machine.travel, {}, {.seed = 8}), machine);
  const TrueErrors twice = in_gauge(once, machine);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(twice.squareness_urad[k], once.squareness_urad[k], 1e-10);
  EXPECT_NEAR(twice.curves[1][0].at(123.0), once.curves[1][0].at(123.0), 1e-11);
}

TEST(SimulatedLengths, AreTheSameForTheSameSeedAndOthersForAnother) {
  const MachineModel machine = simulated_machine();
  const auto lengths = [&](Draw draw) {
    const TrueErrors errors = drawn_errors(machine.travel, {}, draw);
    return simulate_lengths(machine, errors, spread_visits(machine, 10, draw), {.drift_um = 1.0, .outliers = 2}, draw)
        ->lengths.readings;
  };
  const auto first = lengths({.seed = 4}), again = lengths({.seed = 4}), other = lengths({.seed = 4, .trial = 1});
  ASSERT_EQ(first.size(), 120u);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].length_mm, again[i].length_mm);
  EXPECT_NE(first[7].length_mm, other[7].length_mm);
}

TEST(SimulatedLengths, HoldTheFaultsThatWereAskedFor) {
  const MachineModel machine = simulated_machine();
  const Draw draw{.seed = 2};
  const TrueErrors none;
  const SimulatedFaults faults{
      .noise = false, .drift_um = 0.0, .told_breaks = 2, .untold_breaks = 3, .lost = 7, .outliers = 4};
  const auto simulated = simulate_lengths(machine, none, spread_visits(machine, 30, draw), faults, draw);
  ASSERT_TRUE(simulated);
  EXPECT_EQ(simulated->lengths.readings.size(), 12u * 30u - 7u);
  EXPECT_EQ(simulated->jumps.size(), 5u);
  EXPECT_EQ(simulated->outliers.size(), 4u);
  EXPECT_EQ(simulated->lost.size(), 7u);
  std::size_t segments_begun = 0, changes = 0;
  const auto& readings = simulated->lengths.readings;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    if (readings[i].station != readings[i - 1].station || readings[i].tool != readings[i - 1].tool) continue;
    if (readings[i].segment != readings[i - 1].segment) ++segments_begun;
    const auto rest = [&](std::size_t k) {
      const Vector3 p = readings[k].axes_mm + machine.tools[readings[k].tool].offset_mm;
      return distance(p, machine.stations[readings[k].station].at_mm) - readings[k].length_mm;
    };
    if (std::abs(rest(i) - rest(i - 1)) > 0.019) ++changes;
  }
  EXPECT_EQ(segments_begun, 2u);
  EXPECT_GE(changes, 5u);       // each jump
  EXPECT_LE(changes, 5u + 8u);  // and both ends of each outlier
}

TEST(SimulatedLengths, RefuseWhatCannotBeSimulated) {
  MachineModel machine = simulated_machine();
  const std::vector<Visit> visits = spread_visits(machine, 5, {});
  EXPECT_FALSE(simulate_lengths(machine, {}, {}, {}, {}));
  EXPECT_FALSE(simulate_lengths(machine, {}, visits, {.lost = 40}, {}));
  machine.stations.clear();
  EXPECT_FALSE(simulate_lengths(machine, {}, visits, {}, {}));
}

TEST(SimulatedLengths, WithoutNoiseGiveBackTheErrorsInTheGauge) {
  const MachineModel machine = simulated_machine("YXFZ");
  TrueErrors errors;  // parabolas, which splines hold
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const double low = machine.travel.lowest_mm[a], high = machine.travel.highest_mm[a];
      const double size = 3.0 + static_cast<double>(a) - static_cast<double>(m);
      errors.curves[a][m] = table({{low, size}, {0.5 * (low + high), -size}, {high, 2.0 * size}});
    }
  errors.squareness_urad = {11.0, -7.0, 5.0};
  const auto simulated = simulate_lengths(machine, errors, spread_visits(machine, 60, {}), {.noise = false}, {});
  ASSERT_TRUE(simulated);
  const auto found = identify(machine, simulated->lengths, {.sizes = {2, 2, 2}, .drift = DriftModel::none});
  ASSERT_TRUE(found) << found.error().message;
  const TrueErrors gauged = in_gauge(errors, machine);
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const double q = 0.3 * machine.travel.lowest_mm[a] + 0.7 * machine.travel.highest_mm[a];
      const auto value = found->model.motion({a, m}, q);
      ASSERT_TRUE(value);
      EXPECT_NEAR(value->value, gauged.curves[a][m].at(q), 0.02)
          << error_name({a, m});  // second order: 10 µrad · 50 µm
    }
  EXPECT_NEAR(found->model.squareness(Squareness::C0Y)->value, gauged.squareness_urad[0], 0.02);
  EXPECT_NEAR(found->model.squareness(Squareness::B0Z)->value, gauged.squareness_urad[1], 0.02);
  EXPECT_NEAR(found->model.squareness(Squareness::A0Z)->value, gauged.squareness_urad[2], 0.02);
}

/// Jumps of 0.7 and 1.4 mm half way: a station found elsewhere fits four of the readings alone, all others lie beyond.
TEST(SimulatedLengths, ShowABreakThoughNearlyAllReadingsOfItsStationFitNothing) {
  MachineModel machine = simulated_machine();
  machine.repeatability = Length::um(0.3);
  for (const unsigned seed : {490u, 519u}) {
    SCOPED_TRACE(seed);
    const Draw draw{.seed = seed};
    const auto simulated = simulate_lengths(machine, drawn_errors(machine.travel, {}, draw),
                                            spread_visits(machine, 100, draw), {.untold_breaks = 1}, draw);
    ASSERT_TRUE(simulated);
    const auto found = identify(machine, simulated->lengths, {.sizes = {8, 8, 8}});
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->set_aside.size(), 0u);
    ASSERT_EQ(found->breaks.size(), 1u);
    EXPECT_EQ(found->breaks[0].before_reading, simulated->jumps[0].before_reading);
  }
}

TEST(SimulatedLengths, HoldHalfOfTheReversalOfTheDirectionInWhichAxesCameToRest) {
  const MachineModel machine = simulated_machine();
  TrueErrors errors;
  errors.halves[0][0] = table({{0.0, 3.0}, {1000.0, 3.0}});
  const Vector3 at{400, 300, -200};
  const std::vector<Visit> visits = {
      {0, 0, at}, {0, 0, {600, 300, -200}}, {0, 0, at}, {0, 0, {100, 300, -200}}, {0, 0, at}, {0, 0, at}, {0, 1, at}};
  const auto simulated = simulate_lengths(machine, errors, visits, {.noise = false}, {});
  ASSERT_TRUE(simulated);
  const auto expected = std::array{3.0, 3.0, -3.0, -3.0, 3.0, 3.0, 3.0};  // a stop at the same place is no move
  for (std::size_t i = 0; i < visits.size(); ++i) EXPECT_NEAR(simulated->displacements_um[i].x, expected[i], 1e-6) << i;
}

TEST(Visits, InAnyOrderAreTheSameOfEachStationAndTool) {
  const MachineModel machine = simulated_machine();
  const std::vector<Visit> visits = spread_visits(machine, 20, {3, 0}), mixed = in_any_order(visits, {3, 0});
  ASSERT_EQ(mixed.size(), visits.size());
  std::size_t moved = 0;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    EXPECT_EQ(mixed[i].station, visits[i].station);
    EXPECT_EQ(mixed[i].tool, visits[i].tool);
    moved += mixed[i].axes_mm == visits[i].axes_mm ? 0u : 1u;
    const auto run = i / 20 * 20;
    EXPECT_TRUE(std::any_of(visits.begin() + static_cast<std::ptrdiff_t>(run),
                            visits.begin() + static_cast<std::ptrdiff_t>(run + 20),
                            [&](const Visit& v) { return v.axes_mm == mixed[i].axes_mm; }));
  }
  EXPECT_GT(moved, visits.size() / 2);
}

TEST(Courses, AreDrawnWhereNothingIsGivenAndInAnyOrderWhereThereIsReversal) {
  const MachineModel machine = simulated_machine();
  const auto places = [](const std::vector<Visit>& visits) {
    std::vector<double> x;
    for (const Visit& visit : visits) x.push_back(visit.axes_mm.x);
    return x;
  };
  const auto spread = places(spread_visits(machine, 20, {3, 0}));
  const SimulatedCourse plain = simulated_course(machine, {.points = 20}, {3, 0});
  EXPECT_FALSE(plain.errors.has_reversal());
  EXPECT_EQ(places(plain.visits), spread);
  const SimulatedCourse both_ways = simulated_course(machine, {.reversal = Reversal::constant, .points = 20}, {3, 0});
  EXPECT_TRUE(both_ways.errors.has_reversal());
  EXPECT_EQ(places(both_ways.visits), places(in_any_order(spread_visits(machine, 20, {3, 0}), {3, 0})));
  EXPECT_EQ(places(simulated_course(machine, {.errors = &both_ways.errors, .points = 20}, {3, 0}).visits),
            places(both_ways.visits));
  EXPECT_EQ(simulated_course(machine, {.visits = {plain.visits.data(), 3}}, {3, 0}).visits.size(), 3u);
}

}  // namespace
}  // namespace axiometry::volumetric
