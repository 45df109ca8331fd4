// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/studies/lee_experiments.h"

#include <gtest/gtest.h>

#include <cmath>

namespace axiometry::app::lee {
namespace {

double largest(Vector3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

TEST(CoordinateOffset, MovesTheStationByMinusItself) {
  const auto found = coordinate_offset({}, 1.0);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->shifts.size(), 12u);
  // Exactly, but for the rounding of numbers near 1000 mm through a matrix of condition 5.
  EXPECT_LT(found->worst_linear_mm, 1e-10);
  EXPECT_LT(found->worst_refined_mm, 1e-10);
  EXPECT_NEAR(found->shifts[9].refined_mm.x, 1.0, 1e-10);
  EXPECT_NEAR(found->shifts[9].refined_mm.y, 0.0, 1e-10);
}

TEST(CoordinateOffset, ScattersAsThePrintedTableWithAMicrometreOfNoise) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    const auto found = coordinate_offset({.noise = Length::um(1.0), .seed = seed}, 1.0);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_LT(found->worst_linear_mm, 0.020);
    EXPECT_LT(found->worst_refined_mm, 0.020);
    EXPECT_GT(found->worst_refined_mm, 0.0005);
    EXPECT_NEAR(found->worst_printed_mm, 0.01, 1e-12);
  }
}

TEST(CoordinateOffset, NeedsPointsOffEveryCriticalSurface) {
  const Set set{
      .points_mm = {{0, 0, 500}, {900, 0, 500}, {900, 500, 500}, {0, 500, 500}, {450, 200, 500}, {100, 300, 500}}};
  EXPECT_FALSE(coordinate_offset(set, 1.0));
}

TEST(ProportionalError, GivesThePrintedTableFromEachFixture) {
  // Of an independent program (numpy), per fixture: rms and largest departure, mm.
  const double rms[] = {0.0059, 0.0057, 0.0060, 0.0062, 0.0080};
  const double most[] = {0.0212, 0.0213, 0.0196, 0.0178, 0.0226};
  const auto all = fixtures();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto found = proportional_error(all[k], {}, 1);
    ASSERT_TRUE(found) << all[k].name << ": " << found.error().message;
    EXPECT_NEAR(found->rms_mm, rms[k], 6e-5) << all[k].name;
    EXPECT_NEAR(found->largest_mm, most[k], 6e-5) << all[k].name;
    EXPECT_NEAR(found->misprinted_mm, 0.04, 0.01) << all[k].name << ": and not 0.40";
  }
}

TEST(ProportionalError, IsThatOfAnIndependentProgram) {
  // First fixture, eq. 14, first four rows; second, refined, last two rows; to the five digits that were printed.
  const auto first = proportional_error(fixtures()[0], {}, 1);
  ASSERT_TRUE(first);
  const Vector3 linear[] = {{0.05836, -0.10225, -0.0124},
                            {-0.05838, 0.10231, 0.0128},
                            {0.14392, -0.24427, -0.03265},
                            {-0.14384, 0.24417, 0.03305}};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(largest(first->shifts[k].linear_mm - linear[k]), 6e-6) << k;
  const auto second = proportional_error(fixtures()[1], {}, 1);
  ASSERT_TRUE(second);
  EXPECT_LT(largest(second->shifts[10].refined_mm - Vector3{0.14925, -0.25275, -0.07054}), 6e-6);
  EXPECT_LT(largest(second->shifts[11].refined_mm - Vector3{-0.1499, 0.25459, 0.07868}), 6e-6);
}

TEST(ProportionalError, IsOddAndAdditiveToFirstOrder) {
  const auto large = proportional_error(fixtures()[0], {}, 1);
  Fixture tenth = fixtures()[0];
  tenth.error /= 10.0;
  const auto small = proportional_error(tenth, {}, 1);
  ASSERT_TRUE(large && small);
  EXPECT_NEAR(small->oddness_mm / large->oddness_mm, 0.01, 0.002) << "what is left is of second order";
  EXPECT_NEAR(small->additivity_mm / large->additivity_mm, 0.01, 0.002);
}

TEST(ProportionalError, CanSetTheTwoEstimatorsMillimetresApart) {
  const auto found = proportional_error(fixtures()[4], {}, 1);
  ASSERT_TRUE(found);
  EXPECT_GT(found->estimators_apart_mm, 5.0);
}

TEST(Slope, ShowsTheWholeProportionalErrorOnItsAxis) {
  for (const Vector3 origin : {Vector3{}, station_mm}) {
    const auto found = slopes({.origin_mm = origin});
    ASSERT_TRUE(found) << found.error().message;
    for (const LineSlopes& line : found->lines) {
      // Second order: e², and the station's error across the line over the square of the distance.
      EXPECT_NEAR(line.after_um_per_m - line.before_um_per_m, line.expected_change_um_per_m, 0.02) << line.id;
    }
    EXPECT_NEAR(found->lines[1].before_um_per_m, -30.0, 0.02);
    EXPECT_NEAR(found->lines[1].after_um_per_m, 70.0, 0.02);
    EXPECT_NEAR(found->lines[6].expected_change_um_per_m, 100.0 / 3.0, 0.01);
    EXPECT_GT(distance(found->before.refined_mm, found->after.refined_mm), 0.01) << "and yet the station moved";
  }
}

TEST(Slope, IsNotChangedByAConstantOffset) {
  const auto found = slopes({.added = {}, .offset_mm = {1.0, -0.5, 0.25}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->after.refined_mm.x - found->before.refined_mm.x, -1.0, 1e-4)
      << "but for the offset times the scale error, and what that does in other directions";
  for (const LineSlopes& line : found->lines) EXPECT_NEAR(line.after_um_per_m, line.before_um_per_m, 3e-6) << line.id;
}

}  // namespace
}  // namespace axiometry::app::lee
