// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/way_speed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace axiometry::capture {
namespace {

/// A way of that length at that speed, reached and left with that acceleration, at 100 samples a second, in cells.
std::optional<Speed> told_of(double length, double speed, double acceleration, double rate_hz = 100.0) {
  const double ramp_s = std::min(speed / acceleration, std::sqrt(length / acceleration));
  const double top = acceleration * ramp_s, even_s = (length - top * ramp_s) / top;
  const auto place = [&](double t) {
    if (t < ramp_s) return 0.5 * acceleration * t * t;
    if (t < ramp_s + even_s) return 0.5 * top * ramp_s + top * (t - ramp_s);
    const double left_s = std::max(0.0, 2.0 * ramp_s + even_s - t);
    return length - 0.5 * acceleration * left_s * left_s;
  };
  WaySpeed way;
  std::vector<Sample> cell;
  for (int k = 0; k / rate_hz <= 2.0 * ramp_s + even_s + 0.3; ++k) {
    cell.push_back({k / rate_hz, place(k / rate_hz)});
    if (cell.size() < 20) continue;
    way.move_along(cell);
    cell.clear();
  }
  return way.speed(Direction::up, length);
}

TEST(WaySpeed, IsTheFeedWhereTheWayIsLongEnough) {
  for (const double speed : {1.0, 10.0, 50.0, 200.0}) {
    SCOPED_TRACE(speed);
    const auto told = told_of(300.0, speed, 1000.0);
    ASSERT_TRUE(told);
    EXPECT_TRUE(told->even);
    EXPECT_NEAR(told->per_s, speed, 0.01 * speed);
  }
}

TEST(WaySpeed, IsNotEvenWhereTheAxisNeverCameToItsFeed) {
  const auto told = told_of(200.0, 1000.0, 500.0);  // 316 mm/s in the middle
  ASSERT_TRUE(told);
  EXPECT_FALSE(told->even);
  EXPECT_LT(told->per_s, 317.0);
}

TEST(WaySpeed, IsNotToldByAFewSamples) { EXPECT_FALSE(told_of(10.0, 100.0, 10'000.0, 20.0)); }

TEST(WaySpeed, IsThatOfTheWayBehindTheLastTurn) {
  WaySpeed way;
  std::vector<Sample> there, back;
  for (int k = 0; k < 200; ++k) there.push_back({0.01 * k, 1.0 * k});
  for (int k = 0; k < 200; ++k) back.push_back({2.0 + 0.01 * k, 199.0 - 0.25 * k});
  for (std::size_t k = 0; k < 200; k += 20) way.move_along(std::span(there).subspan(k, 20));
  for (std::size_t k = 0; k < 200; k += 20) {
    way.move_along(std::span(back).subspan(k, 20));
    if (k == 20) way.turned(Direction::down);
  }
  const auto told = way.speed(Direction::down, 149.25);
  ASSERT_TRUE(told);
  EXPECT_NEAR(told->per_s, 25.0, 0.1);
}

}  // namespace
}  // namespace axiometry::capture
