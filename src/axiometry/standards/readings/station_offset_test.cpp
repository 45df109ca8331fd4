// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/station_offset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace axiometry {
namespace {

using testing::HasSubstr;

std::vector<Position> positions(std::initializer_list<double> mm) {
  std::vector<Position> result;
  for (double x : mm) result.push_back(Position::native(x));
  return result;
}

Metadata with_station(std::optional<double> at_mm, std::vector<double> u_mm) {
  Metadata metadata;
  if (at_mm) metadata.tracking.station_position = Position::native(*at_mm);
  metadata.tracking.station_uncertainty_mm = std::move(u_mm);
  return metadata;
}

/// Golden: the x line of Lee et al. with Δ∥ = 0, computed with 40 digits.
TEST(StationOffset, HasTheLengthDifferenceOfAnOffsetAcrossTheLine) {
  const auto targets = positions({10, 100, 300, 1100});
  const StationErrors errors(targets, Position::native(0));
  const double square = 0.2715 * 0.2715 + 0.1965 * 0.1965;
  EXPECT_NEAR(errors.error_um(0, square), 5.5635921963, 1e-9);
  EXPECT_NEAR(errors.error_um(1, square), 0.5105643332, 1e-9);
  EXPECT_NEAR(errors.error_um(2, square), 0.1361508519, 1e-9);
  EXPECT_EQ(errors.error_um(3, square), 0.0);
  EXPECT_EQ(errors.nearest_mm(), 10.0);
  EXPECT_EQ(errors.farthest_mm(), 1100.0);
  EXPECT_NEAR(errors.range_um(square), errors.error_um(0, square), 1e-12);
}

TEST(StationOffset, TurnsItsSignWithTheSideOnWhichTheLineLies) {
  const auto targets = positions({-500, -200, 200, 400});
  const StationErrors errors(targets, Position::native(0));
  EXPECT_EQ(errors.error_um(0, 1.0), 0.0);
  EXPECT_NEAR(errors.error_um(1, 1.0), -1000.0 * (0.5 / 200 - 0.5 / 500), 1e-4);
  EXPECT_NEAR(errors.error_um(2, 1.0), 1000.0 * (0.5 / 200 - 0.5 / 500), 1e-4);
  EXPECT_NEAR(errors.range_um(1.0), 2.0 * errors.error_um(2, 1.0), 1e-12);
}

TEST(StationOffset, StaysFiniteOnTheStationItself) {
  const auto targets = positions({0, 1000});
  const StationErrors errors(targets, Position::native(0));
  EXPECT_EQ(errors.error_um(0, 0.0), 0.0);
  EXPECT_NEAR(errors.error_um(0, 4.0), 2000.0 - 2.0, 1e-2);
}

TEST(StationOffset, HasTheDerivativeOfTheError) {
  const auto targets = positions({3, 50, 900});
  const StationErrors errors(targets, Position::native(-1));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(errors.slope_um_per_mm2(i, 0.7), (errors.error_um(i, 0.7001) - errors.error_um(i, 0.6999)) / 2e-4,
                1e-5 * std::abs(errors.slope_um_per_mm2(i, 0.7)) + 1e-9);
}

/// Golden: χ² of one and of two degrees of freedom, and a mixture of both (scipy).
TEST(StationOffset, KnowsTheQuantilesOfASumOfTwoSquares) {
  EXPECT_NEAR(offset_squared_quantile({{}, 1.0, 0.0}, 0.95), 3.841458820694124, 1e-8);
  EXPECT_NEAR(offset_squared_quantile({{}, 1.0, 1.0}, 0.95), 5.991464547107979, 1e-8);
  EXPECT_NEAR(offset_squared_quantile({{}, 1.0, 1e-9}, 0.95), 3.841458820694124, 1e-8);
  EXPECT_NEAR(offset_squared_quantile({{}, 3.0, 3.0}, 0.5), 9.0 * 1.386294361119891, 1e-8);
  EXPECT_NEAR(offset_squared_quantile({{}, 1.0, 0.4}, 0.95), 4.020575366889275, 1e-8);
  EXPECT_EQ(offset_squared_quantile({{}, 0.0, 0.0}, 0.95), 0.0);
}

TEST(StationOffset, KnowsTheMomentsOfASquare) {
  const auto of = [](uncertainty::Distribution::Form form) {
    return square_moments(uncertainty::Distribution::make(std::move(form)).value());
  };
  EXPECT_DOUBLE_EQ(of(uncertainty::Normal{0.0, 0.5}).mean, 0.25);
  EXPECT_DOUBLE_EQ(*of(uncertainty::Normal{0.0, 0.5}).standard_deviation, 0.25 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(of(uncertainty::Normal{2.0, 0.5}).mean, 4.25);
  // x uniform in ± 1: x² has the mean 1/3 and the variance 4/45.
  EXPECT_NEAR(of(uncertainty::Uniform{-1.0, 1.0}).mean, 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(*of(uncertainty::Uniform{-1.0, 1.0}).standard_deviation, std::sqrt(4.0 / 45.0), 1e-6);
  EXPECT_FALSE(of(uncertainty::StudentT{4.0, 0.0, 1.0}).standard_deviation);
  EXPECT_TRUE(of(uncertainty::StudentT{9.0, 0.0, 1.0}).standard_deviation);
}

TEST(StationOffset, IsTakenFromTheMetadataWhereTheyMakeSense) {
  const auto offset = station_offset(with_station(-210.0, {0.02, 0.07}));
  ASSERT_TRUE(offset);
  EXPECT_EQ(offset->larger_mm, 0.07);
  EXPECT_EQ(offset->smaller_mm, 0.02);
  EXPECT_FALSE(station_offset({}));
  EXPECT_EQ(station_offset_problem({}), "");
  EXPECT_FALSE(station_offset(with_station(0.0, {0.0, 0.0})));
  EXPECT_EQ(station_offset_problem(with_station(0.0, {0.0, 0.0})), "");
}

TEST(StationOffset, SaysWhyItIsLeftOut) {
  EXPECT_THAT(station_offset_problem(with_station(0.0, {})), HasSubstr("station_uncertainty_mm"));
  EXPECT_THAT(station_offset_problem(with_station({}, {0.1, 0.1})), HasSubstr("tracking.station_position"));
  EXPECT_THAT(station_offset_problem(with_station(0.0, {0.1})),
              HasSubstr("found 1 standard uncertainty, expected two"));
  EXPECT_THAT(station_offset_problem(with_station(0.0, {0.1, -0.1})), HasSubstr("-0.1 mm"));
  EXPECT_THAT(station_offset_problem(with_station(0.0, {0.1, std::nan("")})), HasSubstr("nan mm"));
  Metadata rotary = with_station(0.0, {0.1, 0.1});
  rotary.axis.kind = AxisKind::rotary;
  EXPECT_THAT(station_offset_problem(rotary), HasSubstr("rotary"));
  EXPECT_FALSE(station_offset(rotary));
}

}  // namespace
}  // namespace axiometry
