// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "axiometry/compensation/prediction.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "tests/support/series.h"

namespace axiometry::compensation {
namespace {

using testing::HasSubstr;
using testing_support::make_series;
using testing_support::RunDeviations;

/// Targets from 0 on, runs of both directions: 3 µm of lost motion over a curve.
Series bent_axis(std::size_t m, std::size_t runs, double noise, unsigned seed = 5) {
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0.0, 1.0);
  std::vector<double> targets;
  for (std::size_t i = 0; i < m; ++i)
    targets.push_back(10.0 * static_cast<double>(i) + 1.5 * std::sin(static_cast<double>(7 * i)));
  std::vector<RunDeviations> up(runs), down(runs);
  for (std::size_t j = 0; j < runs; ++j)
    for (const double x : targets) {
      const double curve = 0.05 * x + 4.0 * std::sin(x / 17.0);
      up[j].push_back(curve + noise * scatter(random));
      down[j].push_back(curve - 3.0 + noise * scatter(random));
    }
  return make_series(targets, up, down);
}

std::vector<double> targets_of(const Series& series) {
  std::vector<double> positions;
  for (const Position p : series.targets()) positions.push_back(p.in_native());
  return positions;
}

double E_with(const Series& series, const AxisCorrection& correction) {
  return iso230_2::evaluate(*corrected_series(series, correction)).parameters.E->in_native();
}

TEST(FitCorrection, TakesTheMeansAwayWhereNodesAreTargets) {
  const Series series = bent_axis(9, 3, 0.4);
  const auto fit = fit_correction(series, AxisKind::linear, {targets_of(series), TableCurves::each_way});
  ASSERT_TRUE(fit) << fit.error().message;
  const iso230_2::Evaluation after = iso230_2::evaluate(*corrected_series(series, fit->correction));
  for (const iso230_2::PositionResult& p : after.positions) {
    EXPECT_NEAR(p.mean_up->in_native(), 0.0, 1e-12);
    EXPECT_NEAR(p.mean_down->in_native(), 0.0, 1e-12);
  }
  const iso230_2::Evaluation before = iso230_2::evaluate(series);
  EXPECT_NEAR(after.parameters.R_up->in_native(), before.parameters.R_up->in_native(), 1e-12) << "scatter stays";
}

TEST(FitCorrection, KnowsWhatABacklashIs) {
  // ↓ lies 3 µm below ↑: the control has to add 3 µm more when it moves down.
  const Series series = bent_axis(9, 2, 0.0);
  const auto fit = fit_correction(series, AxisKind::linear, {targets_of(series), TableCurves::with_backlash});
  ASSERT_TRUE(fit);
  for (std::size_t k = 0; k < 9; ++k)
    EXPECT_NEAR(fit->correction.values(Direction::down)[k] - fit->correction.values(Direction::up)[k], 3.0, 1e-12);
  EXPECT_NEAR(E_with(series, fit->correction), 0.0, 1e-9);
  const auto alone = fit_correction(series, AxisKind::linear, {{0.0}, TableCurves::with_backlash});
  ASSERT_TRUE(alone);
  const auto zeroed = with_zero_at(alone->correction, TableCurves::with_backlash, 0.0);
  EXPECT_DOUBLE_EQ(zeroed->at(55.0, Direction::up), 0.0);
  EXPECT_NEAR(zeroed->at(55.0, Direction::down), 3.0, 1e-12);
}

TEST(FitCorrection, LeavesHalfTheReversalWithOneCurve) {
  const Series series = bent_axis(9, 2, 0.0);
  const auto fit = fit_correction(series, AxisKind::linear, {targets_of(series), TableCurves::both_ways});
  EXPECT_NEAR(E_with(series, fit->correction), 3.0, 1e-9);
}

TEST(FitCorrection, HasNoStepWhereOneDirectionWasMeasuredAlone) {
  // ↓ lies 3 µm below ↑, and was measured at the last targets alone: the curve stays in the middle.
  std::vector<double> targets;
  RunDeviations up, down;
  for (int i = 0; i < 8; ++i) {
    targets.push_back(10.0 * i);
    up.push_back(0.5 * i);
    down.push_back(i < 4 ? std::nan("") : 0.5 * i - 3.0);
  }
  const Series series = make_series(targets, {up, up}, {down, down});
  for (const Method method : {Method::least_squares, Method::interpolation}) {
    const auto fit = fit_correction(series, AxisKind::linear,
                                    {.nodes = targets, .curves = TableCurves::both_ways, .method = method});
    ASSERT_TRUE(fit) << fit.error().message;
    for (std::size_t k = 0; k < 8; ++k)
      for (const Direction direction : {Direction::up, Direction::down})
        EXPECT_NEAR(fit->correction.values(direction)[k], 1.5 - 0.5 * static_cast<double>(k), 1e-9) << k;
  }
}

TEST(FitCorrection, IsNearerToTheReadingsThanInterpolationBetweenTargets) {
  const Series series = bent_axis(21, 3, 0.2);
  const std::vector<double> nodes{0, 40, 80, 120, 160, 200};
  const auto residual = [&](Method method) {
    const auto fit =
        fit_correction(series, AxisKind::linear,
                       {.nodes = nodes, .curves = TableCurves::each_way, .method = method, .hold_ends = true});
    const iso230_2::Evaluation after = iso230_2::evaluate(*corrected_series(series, fit->correction));
    double sum = 0.0;
    for (const auto& p : after.positions) sum += p.mean->in_native() * p.mean->in_native();
    return sum;
  };
  EXPECT_LT(residual(Method::least_squares), 0.8 * residual(Method::interpolation));
}

TEST(FitCorrection, DoesNotSwingBetweenTargets) {
  // Every target lies in the middle between two nodes: without the tie the nodes could swing as they please.
  std::vector<double> targets, up;
  std::mt19937 random(3);
  std::normal_distribution<double> scatter(0.0, 1.0);
  for (int i = 0; i < 30; ++i) targets.push_back(10.0 * i + 5.0), up.push_back(scatter(random));
  const Series series = make_series(targets, {up}, {up});
  std::vector<double> nodes;
  for (int k = 0; k <= 30; ++k) nodes.push_back(10.0 * k);
  const auto fit =
      fit_correction(series, AxisKind::linear, {.nodes = nodes, .curves = TableCurves::both_ways, .hold_ends = true});
  for (const double value : fit->correction.values(Direction::up)) EXPECT_LT(std::abs(value), 8.0);
}

TEST(FitCorrection, SmoothsNoiseAndNotTheError) {
  const auto truth = [](double x) { return 4.0 * std::sin(x / 17.0) + 0.05 * x - 1.5; };
  std::vector<double> nodes;
  for (int k = 1; k < 40; ++k) nodes.push_back(10.0 * k);
  /// Mean square of what the table is off, over many axes.
  const auto error_of = [&](double noise, bool smooth) {
    double sum = 0.0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
      const Series series = bent_axis(41, 1, noise, seed);
      const auto fit =
          fit_correction(series, AxisKind::linear,
                         {.nodes = nodes, .curves = TableCurves::both_ways, .smooth = smooth, .hold_ends = true});
      for (const double x : nodes) sum += std::pow(fit->correction.at(x, Direction::up) + truth(x), 2.0);
    }
    return sum;
  };
  EXPECT_LT(error_of(2.0, true), 0.85 * error_of(2.0, false));
  EXPECT_LT(error_of(0.2, true), 1.05 * error_of(0.2, false));
}

TEST(FitCorrection, ExtrapolatesNothing) {
  const Series series = bent_axis(5, 2, 0.1);
  const FitRequest request{.nodes = {-10, 0, 10, 20, 30, 40}, .curves = TableCurves::each_way};
  EXPECT_THAT(fit_correction(series, AxisKind::linear, request).error().message, HasSubstr("nothing is extrapolated"));
  FitRequest held = request;
  held.hold_ends = true;
  const auto fit = fit_correction(series, AxisKind::linear, held);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->correction.at(-10, Direction::up), fit->correction.at(-5, Direction::up), 0.2);
}

TEST(FitCorrection, WantsBothDirectionsForATableOfEach) {
  const Series one = make_series({0, 10, 20}, {{1, 2, 3}}, {});
  const FitRequest each{.nodes = {0, 10, 20}, .curves = TableCurves::each_way};
  EXPECT_THAT(fit_correction(one, AxisKind::linear, each).error().message, HasSubstr("positive direction alone"));
  EXPECT_TRUE(fit_correction(one, AxisKind::linear, {.nodes = {0, 10, 20}, .curves = TableCurves::both_ways}));
}

TEST(Updated, AddsTheChangeToWhatTheControlHad) {
  const AxisCorrection old = *AxisCorrection::make(AxisKind::linear, {0, 100}, {0, 10}, {2, 12});
  const AxisCorrection change = *AxisCorrection::make(AxisKind::linear, {0, 50, 100}, {1, 1, 1}, {0, 0, 0});
  const auto sum = updated(old, change);
  EXPECT_DOUBLE_EQ(sum->at(50, Direction::up), 6.0);
  EXPECT_DOUBLE_EQ(sum->at(50, Direction::down), 7.0);
}

}  // namespace
}  // namespace axiometry::compensation
