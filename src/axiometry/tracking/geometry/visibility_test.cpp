// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/geometry/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "axiometry/tracking/geometry/obstacles.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::tracking {
namespace {

/// A machine of 800 × 600 × 500 mm; the reflector hangs 120 mm below where the axes stand.
TrackingSetup machine() {
  TrackingSetup setup;
  setup.travel = {{0, 0, -500}, {800, 600, 0}};
  setup.tool_offset_mm = {0, 0, -120};
  setup.station = {{400, 300, -600}, {}};
  setup.limits.elevation_highest_deg = 90.0;
  setup.limits.incidence_most_deg = 180.0;
  return setup;
}

class Places {
 public:
  explicit Places(unsigned seed) : engine_(seed) {}
  double number(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0; }
  Vector3 place(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Obstacle solid() {
    switch (engine_() % 3) {
      case 0: {
        const Vector3 at = place(60);
        return {"box", BoxObstacle{at, at + Vector3{number(5, 80), number(5, 80), number(5, 80)}}};
      }
      case 1: return {"sphere", SphereObstacle{place(60), number(5, 60)}};
      default: return {"cylinder", CylinderObstacle{place(60), number(5, 60), number(5, 80)}};
    }
  }

 private:
  std::mt19937 engine_;
};

TEST(Visibility, DistanceToASegmentIsThatOfItsNearestPoint) {
  EXPECT_DOUBLE_EQ(distance_to_segment({5, 3, 0}, {0, 0, 0}, {10, 0, 0}), 3.0);
  EXPECT_DOUBLE_EQ(distance_to_segment({-3, 4, 0}, {0, 0, 0}, {10, 0, 0}), 5.0);
  EXPECT_DOUBLE_EQ(distance_to_segment({13, 4, 0}, {0, 0, 0}, {10, 0, 0}), 5.0);
  EXPECT_DOUBLE_EQ(distance_to_segment({3, 4, 0}, {0, 0, 0}, {0, 0, 0}), 5.0);
}

TEST(Visibility, DistancesOfSegmentsAndTrianglesAgreeWithDenseSampling) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  Places places(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Obstacle solid = places.solid();
    const Vector3 a = places.place(200), b = places.place(200), s = places.place(200);
    double segment = 1e9, triangle = 1e9;
    for (int i = 0; i <= 4000; ++i) segment = std::min(segment, distance_to(solid, a + i / 4000.0 * (b - a)));
    for (int i = 0; i <= 200; ++i)
      for (int k = 0; k <= 200; ++k) {
        const Vector3 on_way = a + k / 200.0 * (b - a);
        triangle = std::min(triangle, distance_to(solid, s + i / 200.0 * (on_way - s)));
      }
    const double exact = distance_to(solid, a, b), exact_triangle = distance_to(solid, s, a, b);
    EXPECT_LE(exact, segment + 1e-9) << trial;
    EXPECT_GE(exact, segment - distance(a, b) / 4000.0) << trial;
    EXPECT_LE(exact_triangle, triangle + 1e-6) << trial;
    EXPECT_GE(exact_triangle, triangle - (distance(a, b) + distance(s, a) + distance(s, b)) / 200.0) << trial;
    EXPECT_LE(exact_triangle, exact + 1e-6) << trial;
  }
}

TEST(Visibility, APartNearerThanAMarginIsJustThat) {
  Places places(11);
  int cut = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Obstacle solid = places.solid();
    const Vector3 a = places.place(150), b = places.place(150);
    const double margin = places.number(0, 60);
    const auto part = part_nearer_than(solid, a, b, margin);
    cut += part.has_value();
    for (int i = 0; i <= 500; ++i) {
      const double t = i / 500.0, d = distance_to(solid, a + t * (b - a));
      const bool inside = part && t >= part->from && t <= part->to;
      if (std::abs(d - margin) > 1e-6) {
        EXPECT_EQ(inside, d < margin) << trial << " at " << t;
      }
    }
  }
  EXPECT_GT(cut, 50);
  EXPECT_LT(cut, 290);
}

TEST(Visibility, ABoxGrowsWithRoundCorners) {
  const Obstacle box{"vice", BoxObstacle{{0, 0, 0}, {10, 10, 10}}};
  const Vector3 up{0, 0, 5};  // passes the edge at a distance of 3·√2
  EXPECT_FALSE(meets(box, Vector3{13, 13, -5}, Vector3{13, 13, 20}, 4.2));
  EXPECT_TRUE(meets(box, Vector3{13, 13, -5}, Vector3{13, 13, 20}, 4.3));
  EXPECT_TRUE(meets(box, up, up, 0.0));
}

TEST(Visibility, SaysWhatHidesAReflectorWithNumbers) {
  TrackingSetup setup = machine();
  EXPECT_FALSE(hidden_because(setup, {400, 300, -300}));
  EXPECT_EQ(*hidden_because(setup, {400, 300, -450}),
            "150.0 mm from the station, nearer than the least range of 200.0 mm");
  EXPECT_EQ(*hidden_because(setup, {400, 300, -600}), "at the station itself");
  setup.limits.range_most_mm = 250;
  EXPECT_EQ(*hidden_because(setup, {400, 300, -300}), "300.0 mm from the station, farther than the range of 250.0 mm");
  setup = machine();
  setup.limits.elevation_highest_deg = 80;
  EXPECT_EQ(*hidden_because(setup, {400, 300, -300}), "the beam at an elevation of 90.0°, above the highest of 80.0°");
  setup.limits.elevation_highest_deg = 90;
  EXPECT_EQ(*hidden_because(setup, {400, 600, -900}), "the beam at an elevation of −45.0°, below the lowest of −20.0°");
  setup.limits.incidence_most_deg = 60;
  EXPECT_EQ(*hidden_because(setup, {700, 300, -600}),
            "the beam 90.0° off the axis of the reflector, which takes 60.0°");
  setup.obstacles = {{"vice", BoxObstacle{{350, 250, -500}, {450, 350, -400}}}};
  EXPECT_EQ(*hidden_because(setup, {400, 300, -300}), "vice in the beam");
  EXPECT_TRUE(hidden_because(setup, {std::numeric_limits<double>::quiet_NaN(), 300, -300}));
}

TEST(Visibility, TheBeamIsKeptOnAWayWhereItIsKeptAtAllPointsOfIt) {
  Places places(3);
  int kept = 0, lost = 0;
  for (int trial = 0; trial < 300; ++trial) {
    TrackingSetup setup = machine();
    setup.station.position_mm = {0, 0, 0};
    setup.limits.elevation_highest_deg = places.number(40, 90);
    setup.limits.incidence_most_deg = places.number(40, 120);
    setup.limits.reflector_axis = {places.number(-1, 1), places.number(-1, 1), -1};
    if (trial % 2 == 0) setup.obstacles = {places.solid()};
    const Vector3 a = places.place(200) + Vector3{300, 0, 250}, b = places.place(200) + Vector3{300, 0, 250};
    bool all = true;
    for (int i = 0; i <= 2000; ++i) all = all && !hidden_because(setup, a + i / 2000.0 * (b - a));
    const bool exact = !beam_lost_because(setup, a, b);
    if (exact) {
      EXPECT_TRUE(all) << trial;
    }
    kept += exact;
    lost += !exact;
    // The other way round only up to what lies between samples: not more than a few in hundreds.
    if (all && !exact) ADD_FAILURE() << "sampled as kept in trial " << trial << ": " << *beam_lost_because(setup, a, b);
  }
  EXPECT_GT(kept, 20);
  EXPECT_GT(lost, 20);
}

TEST(Visibility, SaysWhatBlocksAWay) {
  TrackingSetup setup = machine();
  EXPECT_FALSE(blocked_because(setup, {0, 0, -400}, {800, 600, -400}));
  EXPECT_EQ(*blocked_because(setup, {0, 0, -400}, {801, 600, -400}),
            "X at 801.000 mm, beyond its travel 0.000 to 800.000 mm");
  EXPECT_EQ(*blocked_because(setup, {0, 300, -590}, {800, 300, -590}),
            "10.0 mm from the station, within its safe radius of 120.0 mm");
  setup.obstacles = {{"vice", CylinderObstacle{{100, 100, -620}, 30, 200}}};
  EXPECT_EQ(*blocked_because(setup, {100, 0, -410}, {100, 300, -410}), "10.0 mm from vice, nearer than 50.0 mm");
}

/// What must hold for every transfer: free all the way, in the travels, and in sight where that is claimed.
void expect_safe(const TrackingSetup& setup, Vector3 from, Vector3 to, const Transfer& transfer) {
  std::vector<Vector3> way = {from};
  way.insert(way.end(), transfer.over_mm.begin(), transfer.over_mm.end());
  way.push_back(to);
  for (std::size_t k = 1; k < way.size(); ++k)
    for (int i = 0; i <= 300; ++i) {
      const Vector3 q = way[k - 1] + i / 300.0 * (way[k] - way[k - 1]), p = q + setup.tool_offset_mm;
      ASSERT_GE(distance(p, setup.station.position_mm), setup.limits.safe_radius_mm - 1e-5);
      for (const Obstacle& obstacle : setup.obstacles) ASSERT_GE(distance_to(obstacle, p), obstacle_margin_mm - 1e-5);
      if (transfer.beam_kept) {
        const auto reason = hidden_because(setup, p);
        ASSERT_FALSE(reason) << *reason;
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_GE(q[axis], setup.travel.lowest_mm[axis] - 1e-6);
        ASSERT_LE(q[axis], setup.travel.highest_mm[axis] + 1e-6);
      }
    }
}

TEST(Visibility, ATransferGoesStraightWhereItMay) {
  const auto transfer = safe_transfer(machine(), {0, 0, -100}, {800, 600, -100});
  ASSERT_TRUE(transfer);
  EXPECT_TRUE(transfer->over_mm.empty());
  EXPECT_TRUE(transfer->beam_kept);
}

TEST(Visibility, ATransferGoesOverTheStation) {
  const TrackingSetup setup = machine();
  const Vector3 from{100, 300, -480}, to{700, 300, -480};
  const auto transfer = safe_transfer(setup, from, to);
  ASSERT_TRUE(transfer);
  EXPECT_EQ(transfer->over_mm.size(), 2u);
  EXPECT_TRUE(transfer->beam_kept);
  expect_safe(setup, from, to, *transfer);
}

TEST(Visibility, ATransferGoesAroundWhatIsTooHigh) {
  TrackingSetup setup = machine();
  setup.station.position_mm = {400, 50, -600};
  setup.obstacles = {{"column", BoxObstacle{{300, 300, -700}, {500, 600, 100}}}};
  const Vector3 from{100, 500, -300}, to{700, 500, -300};
  const auto transfer = safe_transfer(setup, from, to);
  ASSERT_TRUE(transfer);
  EXPECT_FALSE(transfer->over_mm.empty());
  EXPECT_TRUE(transfer->beam_kept);
  expect_safe(setup, from, to, *transfer);
}

TEST(Visibility, ATransferThatCannotKeepTheBeamSaysSo) {
  TrackingSetup setup = machine();
  setup.obstacles = {{"wall", BoxObstacle{{390, -100, -700}, {410, 700, -250}}}};
  setup.station.position_mm = {100, 300, -600};
  const Vector3 from{100, 100, -200}, to{700, 300, -400};
  const auto transfer = safe_transfer(setup, from, to);
  ASSERT_TRUE(transfer);
  EXPECT_FALSE(transfer->beam_kept);
  expect_safe(setup, from, to, *transfer);
}

TEST(Visibility, WithoutAnyWayATransferFailsWithTheReason) {
  TrackingSetup setup = machine();
  setup.obstacles = {{"wall", BoxObstacle{{390, -100, -700}, {410, 700, 100}}}};
  const auto transfer = safe_transfer(setup, {100, 300, -300}, {700, 300, -300});
  ASSERT_FALSE(transfer);
  EXPECT_NE(transfer.error().message.find("straight on: 0.0 mm from wall"), std::string::npos);
  const auto inside = safe_transfer(setup, {400, 300, -300}, {700, 300, -300});
  ASSERT_FALSE(inside);
  EXPECT_NE(inside.error().message.find("at the beginning of a transfer"), std::string::npos);
}

TEST(Visibility, RandomTransfersAreSafeAndTheSameAgain) {
  Places places(5);
  int found = 0;
  for (int trial = 0; trial < 120; ++trial) {
    TrackingSetup setup = machine();
    setup.station.position_mm = {places.number(0, 800), places.number(0, 600), places.number(-700, -400)};
    for (int k = 0; k < trial % 3; ++k) {
      Obstacle solid = places.solid();
      const Vector3 at{places.number(100, 700), places.number(100, 500), places.number(-600, -300)};
      std::visit(
          [&](auto& shape) {
            if constexpr (requires { shape.lowest_mm; }) {
              shape.highest_mm = at + (shape.highest_mm - shape.lowest_mm);
              shape.lowest_mm = at;
            } else if constexpr (requires { shape.centre_mm; }) {
              shape.centre_mm = at;
            } else {
              shape.base_mm = at;
            }
          },
          solid.shape);
      setup.obstacles.push_back(solid);
    }
    const Vector3 from{places.number(0, 800), places.number(0, 600), places.number(-500, 0)};
    const Vector3 to{places.number(0, 800), places.number(0, 600), places.number(-500, 0)};
    const auto transfer = safe_transfer(setup, from, to);
    if (!transfer) continue;
    ++found;
    expect_safe(setup, from, to, *transfer);
    EXPECT_EQ(safe_transfer(setup, from, to)->over_mm, transfer->over_mm);
  }
  EXPECT_GT(found, 80);
}

}  // namespace
}  // namespace axiometry::tracking
