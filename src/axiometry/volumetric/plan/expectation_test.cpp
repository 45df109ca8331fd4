// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/plan/expectation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "axiometry/volumetric/field/unseen_reasons.h"
#include "axiometry/volumetric/plan/point_set.h"

namespace axiometry::volumetric {
namespace {

constexpr Vector3 short_tool = {0, 0, -150}, long_tool = {0, 0, -300}, lateral_tool = {120, 60, -180};

MachineModel planned_machine(const char* chain, const std::vector<Vector3>& tools, std::size_t stations = 4) {
  MachineModel machine{.chain = *KinematicChain::make(chain)};
  machine.travel = {{0, 0, -500}, {1000, 600, 0}};
  for (const Vector3& t : tools) machine.tools.push_back({"T" + std::to_string(machine.tools.size() + 1), t});
  const Vector3 places[] = {{-150, -120, -700}, {1150, -100, -650}, {500, 720, -680}, {200, 300, -900}};
  for (std::size_t s = 0; s < stations; ++s) machine.stations.push_back({"S" + std::to_string(s + 1), places[s]});
  return machine;
}

Expectation expected_of(const MachineModel& machine, std::size_t points = 100) {
  const ExpectOptions options{.curves = CurveKind::legendre, .sizes = {5, 5, 5}, .drift = false};
  auto expected = expect(machine, spread_visits(machine, points, {}), options);
  EXPECT_TRUE(expected) << (expected ? "" : expected.error().message);
  return *std::move(expected);
}

struct RankCase {
  const char* name;
  std::vector<Vector3> tools;
  std::array<std::size_t, 3> nulls;  ///< of FXYZ, XFYZ, YXFZ
};

/// Computed outside of this project: shared specification, table 2.4, of four stations and polynomials of degree 5.
TEST(Expectation, HasTheRankOfTheTableForEachSetOfToolsAndChain) {
  const RankCase cases[] = {
      {"one tool on the spindle's axis", {short_tool}, {20, 20, 19}},
      {"one lateral tool", {lateral_tool}, {20, 20, 19}},
      {"two lengths", {short_tool, long_tool}, {10, 10, 9}},
      {"two tools, one of them lateral", {short_tool, lateral_tool}, {5, 5, 5}},
      {"three tools on one line", {short_tool, {60, 30, -165}, lateral_tool}, {5, 5, 5}},
      {"three tools that form a triangle", {short_tool, long_tool, lateral_tool}, {0, 0, 0}},
  };
  for (const RankCase& c : cases)
    for (std::size_t k = 0; k < 3; ++k) {
      const char* const chains[] = {"FXYZ", "XFYZ", "YXFZ"};
      const Expectation expected = expected_of(planned_machine(chains[k], c.tools));
      EXPECT_EQ(expected.rank.null_directions, c.nulls[k]) << c.name << ", " << chains[k];
      EXPECT_EQ(expected.unseen.empty(), c.nulls[k] == 0) << c.name << ", " << chains[k];
      EXPECT_EQ(expected.reasons.empty(), c.nulls[k] == 0) << c.name << ", " << chains[k];
    }
}

/// From the same table.
TEST(Expectation, HasTheRankOfTheTableForEachNumberOfStations) {
  const std::size_t nulls[] = {17, 4, 0, 0};
  for (std::size_t stations = 1; stations <= 4; ++stations)
    EXPECT_EQ(
        expected_of(planned_machine("FXYZ", {short_tool, long_tool, lateral_tool}, stations), 200).rank.null_directions,
        nulls[stations - 1])
        << stations;
}

TEST(Expectation, NamesTheErrorsThatTwoLengthsOfToolDoNotTell) {
  const Expectation expected = expected_of(planned_machine("FXYZ", {short_tool, long_tool}));
  EXPECT_EQ(error_list(expected.unseen), "ECY and ECZ");
  EXPECT_FALSE(expected.errors[1 * motion_count + 5].u_mean);  // ECY
  EXPECT_TRUE(expected.errors[0].u_mean);                      // EXX
  EXPECT_NE(expected.reasons.front().find("line"), std::string::npos);
}

TEST(Expectation, IsWhatIdentifyStatesAfterwards) {
  const MachineModel machine = planned_machine("XFYZ", {short_tool, long_tool, lateral_tool});
  const std::vector<Visit> visits = spread_visits(machine, 80, {});
  const TrueErrors errors = drawn_errors(machine.travel, {4.0, 6.0}, {.seed = 3});
  const auto simulated = simulate_lengths(machine, errors, visits, {}, {.seed = 3});
  ASSERT_TRUE(simulated);
  const auto found = identify(machine, simulated->lengths, {.sizes = {5, 5, 5}, .drift = DriftModel::none});
  ASSERT_TRUE(found) << found.error().message;
  const auto expected = expect(machine, visits, {.sizes = {5, 5, 5}, .drift = false});
  ASSERT_TRUE(expected);
  EXPECT_EQ(found->rank.unknowns, expected->rank.unknowns);
  const double factor = std::sqrt(found->variance_factor());
  for (std::size_t k = 0; k < 3; ++k) {
    const double stated = found->model.squareness(static_cast<Squareness>(k))->u / factor;
    EXPECT_NEAR(stated, *expected->errors[18 + k].u_mean, 0.02 * stated);
  }
  for (const double q : {0.0, 250.0, 1000.0})
    EXPECT_LE(found->model.motion({0, 0}, q)->u / factor, 1.02 * *expected->errors[0].u_most);
}

TEST(Expectation, FallsWithTheRootOfTheReadingsAndRisesWithTheRepeatability) {
  MachineModel machine = planned_machine("XFYZ", {short_tool, long_tool, lateral_tool});
  const double few = *expected_of(machine, 100).u_rms_um, many = *expected_of(machine, 400).u_rms_um;
  EXPECT_NEAR(few / many, 2.0, 0.25);
  machine.repeatability = Length::um(1.0);
  EXPECT_GT(*expected_of(machine, 100).u_rms_um, 3.0 * few);
}

TEST(Expectation, RefusesAPlanWithoutStationsOrPoints) {
  MachineModel machine = planned_machine("XFYZ", {short_tool});
  EXPECT_FALSE(expect(machine, {}, {}));
  const std::vector<Visit> outside = {{0, 0, {2000, 0, 0}}};
  EXPECT_FALSE(expect(machine, outside, {}));
  machine.stations.clear();
  EXPECT_FALSE(expect(machine, outside, {}));
}

TEST(PointSet, FillsTheTravelsEvenly) {
  const TravelBox travel = {{0, -10, 5}, {800, 10, 105}};
  const std::vector<Vector3> points = spread_points(travel, 800, {0.2, 0.9, 0.5});
  ASSERT_EQ(points.size(), 800u);
  std::array<int, 64> counts{};
  for (const Vector3& p : points) {
    std::size_t cell = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      ASSERT_GE(p[a], travel.lowest_mm[a]);
      ASSERT_LE(p[a], travel.highest_mm[a]);
      const double share = (p[a] - travel.lowest_mm[a]) / (travel.highest_mm[a] - travel.lowest_mm[a]);
      cell = 4 * cell + static_cast<std::size_t>(std::min(3.0, std::floor(4.0 * share)));
    }
    ++counts[cell];
  }
  EXPECT_GE(std::ranges::min(counts), 8);  // 12.5 in each
  EXPECT_LE(std::ranges::max(counts), 17);
}

TEST(PointSet, IsVisitedOnAShortWayAndWhole) {
  const TravelBox travel = {{0, 0, 0}, {1000, 600, 500}};
  std::vector<Vector3> points = spread_points(travel, 150, {});
  const auto way = [](const std::vector<Vector3>& places) {
    double sum = 0.0;
    for (std::size_t k = 1; k < places.size(); ++k) sum += distance(places[k - 1], places[k]);
    return sum;
  };
  std::vector<Vector3> tour = short_tour(points);
  EXPECT_LT(way(tour), 0.35 * way(points));
  const auto less = [](Vector3 a, Vector3 b) { return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z); };
  std::ranges::sort(points, less);
  std::ranges::sort(tour, less);
  EXPECT_EQ(points, tour);
}

}  // namespace
}  // namespace axiometry::volumetric
