// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ranges>

#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/figures/layout/layout_test_support.h"

namespace axiometry::report {
namespace {

using testing::all_words;
using ::testing::Contains;
using testing::crowded_layout;
using testing::expect_golden;
using testing::fault_of;
using ::testing::IsSupersetOf;
using ::testing::Not;
using testing::seven_lines_layout;

TEST(LayoutFigure, OfSevenLinesIsTheGoldenOne) {
  const Figure figure = layout_figure(seven_lines_layout(), {});
  EXPECT_EQ(fault_of(figure), "");
  expect_golden(figure, "layout_seven_lines");
}

TEST(LayoutFigure, NamesEveryLineEvenWhereItIsCrowded) {
  const Figure figure = layout_figure(crowded_layout(), {});
  EXPECT_EQ(fault_of(figure), "");
  EXPECT_THAT(all_words(figure), IsSupersetOf({"x", "y", "z", "xy", "xz", "yz", "xyz", "vice", "station", "6"}));
  expect_golden(figure, "layout_crowded");
}

TEST(LayoutFigure, ShowsTheTravelsInTheirLengths) {
  const Figure figure = layout_figure(seven_lines_layout(), {});
  EXPECT_THAT(all_words(figure), IsSupersetOf({"1000", "600", "500"}));
}

TEST(LayoutFigure, CallsStationsAndPointsByTheirNamesWhereTheyHaveSome) {
  Layout layout{.stations_mm = {{0, 0, 0}, {900, 0, 100}},
                .points_mm = {{100, 200, 300}, {500, 400, 100}},
                .station_names = {"door", "spindle"},
                .point_names = {"P7", "P8"}};
  EXPECT_THAT(all_words(layout_figure(layout, {})), IsSupersetOf({"door", "spindle", "P7", "P8"}));
  layout.stations_mm.push_back({1e300, 0, 0});
  EXPECT_THAT(all_words(layout_figure(layout, {})), IsSupersetOf({"S1", "S2", "P7", "P8"}));
}

TEST(LayoutFigure, UsesTheDecimalMarkOfTheOptions) {
  Layout layout = seven_lines_layout();
  layout.box->highest_mm.x = 1000.5;
  Options options;
  options.numbers.decimal_mark = ',';
  EXPECT_THAT(all_words(layout_figure(layout, options)), Contains("1000,5"));
}

TEST(LayoutFigure, StaysInItsBoxForAnythingThatMayBeAskedFor) {
  std::vector<Layout> layouts;
  layouts.push_back({});
  layouts.push_back({.stations_mm = {{1, 2, 3}}});
  layouts.push_back({.points_mm = {{1, 2, 3}}});
  layouts.push_back({.stations_mm = {{4e5, -3e5, 1e5}}, .points_mm = {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}});
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  layouts.push_back({.box = TravelBox{{0, nan, 0}, {1, 1, 1}},
                     .stations_mm = {{nan, 0, 0}, {1, 1, 1}},
                     .safe_radius_mm = inf,
                     .lines = {{{0, 0, 0}, {inf, 0, 0}, "x"}},
                     .points_mm = {{0, 0, nan}}});
  Layout outside = seven_lines_layout();
  outside.stations_mm = {{-900, 300, -400}};
  layouts.push_back(outside);
  Layout named = crowded_layout();
  for (Layout::Item& item : named.lines) item.label += " <&>" + std::string(200, 'W');
  for (Obstacle& obstacle : named.obstacles) obstacle.name += std::string(200, 'W');
  layouts.push_back(named);
  Layout flat = seven_lines_layout();
  flat.box->highest_mm.z = flat.box->lowest_mm.z;
  layouts.push_back(flat);
  Layout thin{.box = TravelBox{{0, 0, 0}, {20000, 100, 50}}, .stations_mm = {{10, 10, 10}}, .safe_radius_mm = 40};
  layouts.push_back(thin);
  std::swap(thin.box->highest_mm.x, thin.box->highest_mm.z);
  layouts.push_back(thin);
  Layout huge = seven_lines_layout();
  huge.box->highest_mm = {9e8, 3e8, 2e8};
  layouts.push_back(huge);
  Layout many{.stations_mm = {{0, 0, 0}, {900, 0, 0}, {0, 900, 0}, {400, 400, 900}}};
  for (int k = 0; k < 10'000; ++k)
    many.points_mm.push_back({k % 100 * 10.0, k / 100 * 10.0, 100.0 * std::sin(k * 0.1)});
  layouts.push_back(many);
  for (std::size_t k = 0; k < layouts.size(); ++k) EXPECT_EQ(fault_of(layout_figure(layouts[k], {})), "") << k;
}

RC_GTEST_PROP(LayoutFigure, StaysInItsBoxWithoutOverlapForAnySetUp, ()) {
  const double size = std::pow(10.0, *rc::gen::inRange(-3, 7));
  const auto number = [&] { return size * 1e-3 * *rc::gen::inRange(-1000, 1000); };
  const auto point = [&] { return Vector3{number(), number(), number()}; };
  Layout layout;
  if (*rc::gen::inRange(0, 4) > 0) layout.box = TravelBox{{-size, -size, -size}, point()};
  if (*rc::gen::inRange(0, 2) > 0) layout.safe_radius_mm = std::abs(number());
  for (int k = *rc::gen::inRange(0, 4); k > 0; --k) layout.stations_mm.push_back(point());
  for (int k = *rc::gen::inRange(0, 12); k > 0; --k)
    layout.lines.push_back({point(), point(), "line " + std::to_string(k), k % 3 == 0});
  for (int k = *rc::gen::inRange(0, 25); k > 0; --k) layout.points_mm.push_back(point());
  if (*rc::gen::inRange(0, 2) > 0) layout.way_mm = layout.points_mm;
  for (int k = *rc::gen::inRange(0, 3); k > 0; --k) {
    layout.obstacles.push_back({"box " + std::to_string(k), BoxObstacle{point(), point()}});
    layout.obstacles.push_back({"ball " + std::to_string(k), SphereObstacle{point(), number()}});
    layout.obstacles.push_back({"post " + std::to_string(k), CylinderObstacle{point(), number(), number()}});
  }
  RC_ASSERT(fault_of(layout_figure(layout, {})) == "");
}

TEST(LayoutFigure, KeepsItsMarginBesideAFlatView) {
  for (const double lean_mm : {0.0, 1.0, 20.0, 100.0}) {
    Layout layout{.lines = {{{0, 0, 0}, {1000, lean_mm, 30}, "x"}}};
    const Figure figure = layout_figure(layout, {});
    const auto reaches = [](const auto& operation) { return testing::box_of(operation).right; };
    EXPECT_LT(std::ranges::max(figure.operations | std::views::transform(reaches)), figure.width - 3.0) << lean_mm;
  }
}

TEST(LayoutFigure, DrawsLostLinesDashedAndGrey) {
  Layout layout = seven_lines_layout();
  for (Layout::Item& item : layout.lines) item.lost = true;
  EXPECT_THAT(all_words(layout_figure(layout, {})), Contains("cannot be measured"));
  EXPECT_THAT(all_words(layout_figure(layout, {})), Not(Contains("line of one axis")));
}

TEST(LayoutFigure, DrawsNoMoreThanSomeOfManyPoints) {
  Layout layout;
  for (int k = 0; k < 100'000; ++k) layout.points_mm.push_back({k * 0.01, k % 317 * 1.0, k % 101 * 1.0});
  const Figure figure = layout_figure(layout, {});
  EXPECT_LT(figure.operations.size(), 9000u);
  EXPECT_THAT(all_words(figure), Contains("some of 100000 points"));
}

TEST(LayoutFigure, ShowsOfARasterMoreThanOneOfItsPlanes) {
  Layout layout;
  for (int k = 0; k < 20'000; ++k) layout.points_mm.push_back({k / 10 * 0.5, k % 601 * 1.0, k % 10 * 50.0});
  std::map<long, int> at_a_height;
  for (const Operation& operation : layout_figure(layout, {}).operations)
    if (const Disc* disc = std::get_if<Disc>(&operation)) ++at_a_height[std::lround(1e3 * disc->centre.y)];
  for (const auto& [height, count] : at_a_height) EXPECT_LT(count, 600) << height;  // of 4 × 2000, about 2 × 200
}

}  // namespace
}  // namespace axiometry::report
