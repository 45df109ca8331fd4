// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/thinned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace axiometry::report::plot {
namespace {

std::vector<Point> wave(std::size_t count) {
  std::vector<Point> curve;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = 430.0 * double(k) / double(count - 1);
    curve.push_back({50.0 + x, 100.0 + 30.0 * std::sin(0.05 * x) + 5.0 * std::sin(1000.0 * double(k * k % 977))});
  }
  return curve;
}

TEST(Thinned, LeavesCurvesThatAPageCanShow) {
  for (std::size_t count : {1u, 2u, 1500u}) {
    const auto curve = wave(count == 1 ? 2 : count);
    const auto kept = thinned(curve);
    ASSERT_EQ(kept.size(), curve.size());
    for (std::size_t k = 0; k < kept.size(); ++k) EXPECT_EQ(kept[k].y, curve[k].y);
  }
  EXPECT_TRUE(thinned({}).empty());
}

TEST(Thinned, KeepsLowestAndHighestOfEveryColumnAndBothEnds) {
  const auto curve = wave(30000);
  const auto kept = thinned(curve);
  EXPECT_LT(kept.size(), 2200u);
  EXPECT_EQ(kept.front().x, curve.front().x);
  EXPECT_EQ(kept.back().x, curve.back().x);
  for (std::size_t k = 1; k < kept.size(); ++k) EXPECT_LT(kept[k - 1].x, kept[k].x);
  for (const Point& p : curve) {
    double lowest = 1e9, highest = -1e9;
    for (const Point& q : kept)
      if (std::abs(q.x - p.x) <= 0.4) lowest = std::min(lowest, q.y), highest = std::max(highest, q.y);
    ASSERT_LE(lowest, p.y);
    ASSERT_GE(highest, p.y);
  }
}

TEST(Thinned, KeepsOneValueThatStandsOut) {
  std::vector<Point> curve;
  for (std::size_t k = 0; k < 20000; ++k) curve.push_back({0.02 * double(k), k == 12345 ? -7.0 : 1.0});
  const auto kept = thinned(curve);
  EXPECT_EQ(std::ranges::count(kept, -7.0, &Point::y), 1);
}

}  // namespace
}  // namespace axiometry::report::plot
