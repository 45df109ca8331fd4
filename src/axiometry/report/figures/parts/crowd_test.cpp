// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/crowd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace axiometry::report::plot {
namespace {

/// Over 400 pt, evenly between 80 and 120 and in no order.
std::vector<Point> even_points(std::size_t count) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k)
    points.push_back(
        {50.0 + 400.0 * double(k) / double(count), 80.0 + 40.0 * std::fmod(0.6180339887 * double(k), 1.0)});
  return points;
}

TEST(Crowd, LeavesPointsThatCanBeToldApart) {
  const Crowd shown = crowd(even_points(1500));
  EXPECT_EQ(shown.dots.size(), 1500u);
  EXPECT_TRUE(shown.stretches.empty());
  EXPECT_TRUE(crowd({}).dots.empty());
}

TEST(Crowd, OfManyShowsWhereTheyAreAndNotOnlyHowFarTheyGo) {
  for (std::size_t count : {20'000u, 200'000u}) {
    const auto points = even_points(count);
    const Crowd shown = crowd(points);
    ASSERT_EQ(shown.stretches.size(), 66u) << count;  // 400 pt, each of 6 pt or a little more
    EXPECT_LE(shown.dots.size(), 2 * 66u);
    EXPECT_NEAR(shown.stretches.back().right, points.back().x, 1e-9);
    double median = 0.0, half = 0.0;
    for (const CrowdStretch& s : shown.stretches) {
      median += s.median / 66.0;
      half += (s.low - s.high) / 2.0 / 66.0;
    }
    EXPECT_NEAR(median, 100.0, 0.3);
    EXPECT_NEAR(half, 19.0, 0.2);  // 95 % of 20
    const auto [least, largest] = std::ranges::minmax_element(points, {}, &Point::y);
    const auto has = [&](double y) { return std::ranges::count(shown.dots, y, &Point::y) == 1; };
    EXPECT_TRUE(has(least->y));
    EXPECT_TRUE(has(largest->y));
  }
}

TEST(Crowd, HasABandOfJustTooManyPointsToo) {  // the legend tells of one
  for (const std::size_t count : {1501u, 2000u, 3000u})
    EXPECT_FALSE(crowd(even_points(count)).stretches.empty()) << count;
}

TEST(Crowd, ShowsEachPointOfAStretchThatHasFew) {
  auto points = even_points(20'000);
  for (int k = 0; k < 39; ++k) points.push_back({600.0, 100.0 + k});
  EXPECT_EQ(std::ranges::count(crowd(points).dots, 600.0, &Point::x), 39);
}

TEST(Crowd, IsCarriedByOnePlace) {
  const Crowd shown = crowd(std::vector<Point>(5000, Point{10.0, 20.0}));
  ASSERT_EQ(shown.stretches.size(), 1u);
  EXPECT_EQ(shown.stretches.front().median, 20.0);
  EXPECT_TRUE(shown.dots.empty());
}

TEST(PointsApart, KeepsOneOfThoseThatLieUponOneAnother) {
  EXPECT_EQ(apart({{1.0, 1.0}, {1.1, 1.1}, {9.0, 1.0}}, 1.6).size(), 2u);
}

}  // namespace
}  // namespace axiometry::report::plot
