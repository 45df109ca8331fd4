// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/compensated_positions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "axiometry/compensation/fit.h"
#include "tests/support/series.h"

namespace axiometry::compensation {
namespace {

using testing_support::make_series;
using testing_support::RunDeviations;
using Curve = std::function<double(double)>;

std::vector<double> equal_targets(std::size_t count, double step) {
  std::vector<double> targets;
  for (std::size_t i = 0; i < count; ++i) targets.push_back(static_cast<double>(i) * step);
  return targets;
}

constexpr double reversal_of_them = -3.0, scatter_of_them = 0.8;

/// The axis does `curve` in ↑ and that less 3 µm in ↓, with a scatter of 0.8 µm.
axiometry::Test tested(const Curve& curve, const std::vector<double>& targets, std::size_t runs,
                       std::mt19937_64& random) {
  std::normal_distribution<double> scatter(0.0, scatter_of_them);
  std::vector<RunDeviations> up(runs), down(runs);
  for (std::size_t j = 0; j < runs; ++j)
    for (const double x : targets) {
      up[j].push_back(curve(x) + scatter(random));
      down[j].push_back(curve(x) + reversal_of_them + scatter(random));
    }
  return {Metadata{}, make_series(targets, up, down), {}};
}

/// The numbers of the table as whole micrometres.
AxisCorrection rounded(const AxisCorrection& exact) {
  std::array<std::vector<double>, 2> values;
  for (const Direction d : {Direction::up, Direction::down})
    for (const double x : exact.values(d)) values[static_cast<std::size_t>(d)].push_back(std::round(x));
  return *AxisCorrection::make(exact.kind(), exact.positions(), values[0], values[1]);
}

/// A long wave and three short ones that targets 50 mm apart do not follow.
Curve any_axis(std::mt19937_64& random) {
  std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
  std::vector<std::array<double, 3>> waves;  // amplitude, length, phase
  for (const auto& [amplitude, length] :
       {std::pair{12.0, 700.0}, std::pair{0.8, 37.3}, std::pair{0.8, 61.7}, std::pair{0.6, 83.1}})
    waves.push_back({amplitude, length, phase(random)});
  return [waves](double x) {
    double sum = 0.03 * x;
    for (const auto& [amplitude, length, at] : waves)
      sum += amplitude * std::sin(2.0 * std::numbers::pi * x / length + at);
    return sum;
  };
}

struct Share {
  int within = 0, all = 0;
  double bounds = 0.0;
  void see(double error, double bound) {
    within += std::abs(error) <= bound;
    ++all;
    bounds += bound;
  }
  double value() const { return static_cast<double>(within) / all; }
  double bound() const { return bounds / all; }
};

/// Where approaches end with the table, against what was said of them.
struct Coverage {
  Share means, approaches, between;
};

Coverage coverage_of(const std::vector<double>& nodes, std::size_t axes, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> scatter(0.0, scatter_of_them);
  const std::vector<double> targets = equal_targets(11, 50.0);
  Coverage found;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const Curve curve = any_axis(random);
    const axiometry::Test test = tested(curve, targets, 5, random);
    const auto fit = fit_correction(test.series, AxisKind::linear, {.nodes = nodes, .curves = TableCurves::each_way});
    EXPECT_TRUE(fit);
    const AxisCorrection table = rounded(fit->correction);
    const auto known = compensated_positions(test, {table, fit->correction});
    EXPECT_TRUE(known);
    const auto truth = [&](double x, Direction d) {
      return curve(x) + (d == Direction::up ? 0.0 : reversal_of_them) + table.at(x, d);
    };
    double zero = 0.0;
    for (const double x : targets) zero += 0.5 * (truth(x, Direction::up) + truth(x, Direction::down)) / 11.0;
    for (const Direction d : {Direction::up, Direction::down}) {
      for (std::size_t i = 0; i < targets.size(); ++i) {
        const CompensatedMean& own = d == Direction::up ? *known->targets[i].up : *known->targets[i].down;
        const double off = truth(targets[i], d) - zero - own.residual;
        found.means.see(off, own.mean->U.in_native());
        found.approaches.see(off + scatter(random), own.approach->U.in_native());
      }
      for (const CompensatedGap& gap : known->gaps[static_cast<std::size_t>(d)]) {
        std::uniform_real_distribution<double> along(gap.from.in_native(), gap.to.in_native());
        found.between.see(truth(along(random), d) - zero + scatter(random),
                          std::abs(gap.residual) + gap.approach->U.in_native());
      }
    }
  }
  return found;
}

TEST(CompensatedPositions, HoldWhatTheyPromise) {
  const Coverage found = coverage_of(equal_targets(11, 50.0), 200, 21);
  // 95.45 %: 4 400 of each, three standard deviations of the binomial are 0.9 %.
  EXPECT_NEAR(found.means.value(), 0.9545, 0.01);
  EXPECT_NEAR(found.approaches.value(), 0.9545, 0.01);
  EXPECT_GT(found.between.value(), 0.9545) << "on the safe side";
  EXPECT_LT(found.between.bound(), 3.0 * found.approaches.bound()) << "and of use";
}

TEST(CompensatedPositions, HoldWhereTheTableIsCoarserThanTheTargets) {
  const Coverage found = coverage_of(equal_targets(6, 100.0), 100, 22);
  EXPECT_NEAR(found.means.value(), 0.9545, 0.014);
  EXPECT_NEAR(found.approaches.value(), 0.9545, 0.014);
  EXPECT_GT(found.between.value(), 0.9545);
}

TEST(CompensatedPositions, KnowFromTheTargetsHowFarTheAxisIsBetweenThem) {
  std::mt19937_64 random(3);
  const std::vector<double> targets = equal_targets(41, 10.0);
  const auto q_of = [&](const Curve& curve) {
    const axiometry::Test test = tested(curve, targets, 60, random);
    const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
    return *compensated_positions(test, {none, none})->between_targets[0];
  };
  // x = a P²: a (10 mm)²/4 in the middle between two targets; a = 0.05 µm/mm².
  EXPECT_NEAR(q_of([](double x) { return 0.05 * x * x; }), 1.25, 0.2);
  std::normal_distribution<double> anything(0.0, 2.0);
  std::vector<double> rough(targets.size());
  for (double& x : rough) x = anything(random);
  const auto at = [&](double x) { return rough[static_cast<std::size_t>(std::lround(x / 10.0))]; };
  EXPECT_NEAR(q_of(at), 2.0 * std::sqrt(1.5), 0.8) << "each target its own";
}

TEST(CompensatedPositions, TellWhatRoundingDoes) {
  std::mt19937_64 random(5);
  const std::vector<double> targets = equal_targets(5, 100.0);
  const axiometry::Test test = tested([](double x) { return 0.0437 * x; }, targets, 5, random);
  const auto fit = fit_correction(test.series, AxisKind::linear, {.nodes = targets, .curves = TableCurves::each_way});
  const AxisCorrection table = rounded(fit->correction);
  const auto known = compensated_positions(test, {table, fit->correction});
  for (const CompensatedTarget& target : known->targets) {
    // At nodes that are targets the fit is −x̄_i: what is left is the rounding, but for the zero.
    EXPECT_NEAR(target.up->residual, target.up->rounding - known->zero, 1e-9);
    EXPECT_LE(std::abs(target.up->rounding), 0.5);
    EXPECT_GT(target.up->approach->u, target.up->mean->u);
  }
  EXPECT_GE(*known->anywhere, *known->at_targets);
  ASSERT_EQ(known->notes.size(), 1u);
  EXPECT_THAT(known->notes[0], testing::HasSubstr("only the scatter"));
}

TEST(CompensatedPositions, CountTheInstrumentWhereItIsStated) {  // Lira & Cargill, eq. 8
  std::mt19937_64 random(6);
  const std::vector<double> targets = equal_targets(5, 100.0);
  axiometry::Test test = tested([](double x) { return 0.02 * x; }, targets, 5, random);
  const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
  const auto without = compensated_positions(test, {none, none});
  test.metadata.gum.distributions = {{"scale:laser", "normal 0 20"}};  // µm/m: 8 µm at 400 mm
  const auto with = compensated_positions(test, {none, none});
  ASSERT_TRUE(without && with);
  EXPECT_TRUE(with->notes.empty());
  const auto u = [](const auto& known, std::size_t i) { return known->targets[i].up->mean->u.in_native(); };
  EXPECT_DOUBLE_EQ(u(with, 0), u(without, 0));
  EXPECT_NEAR(u(with, 4), std::hypot(u(without, 4), 8.0), 1e-9);
  EXPECT_LT(with->targets[4].up->approach->k, 2.05) << "of no finite degrees of freedom";
  // Noise of known size is no estimate of n − 1 degrees of freedom, though it stands among the approaches.
  test.metadata.gum.distributions.clear();
  test.metadata.uncertainty.environmental_variation = Deviation::native(30.0);
  const auto drifting = compensated_positions(test, {none, none});
  ASSERT_TRUE(drifting) << drifting.error().message;
  EXPECT_GT(u(drifting, 0), 3.0);
  EXPECT_LT(drifting->targets[0].up->approach->k, 2.05);
}

TEST(CompensatedPositions, SayNothingOfWhatNobodyKnows) {
  std::mt19937_64 random(7);
  const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
  const Curve line = [](double x) { return 0.02 * x; };
  const auto once = compensated_positions(tested(line, equal_targets(5, 100.0), 1, random), {none, none});
  ASSERT_TRUE(once) << once.error().message;
  EXPECT_FALSE(once->at_targets) << "one approach has no scatter";
  EXPECT_FALSE(once->anywhere);
  EXPECT_FALSE(once->targets[0].up->mean);
  const auto two = compensated_positions(tested(line, equal_targets(2, 100.0), 5, random), {none, none});
  ASSERT_TRUE(two);
  EXPECT_TRUE(two->at_targets);
  EXPECT_FALSE(two->anywhere) << "two targets do not tell what is between them";
  EXPECT_FALSE(two->between_targets[0]);
}

TEST(CompensatedPositions, CountFromWhatWasActiveDuringTheTest) {
  std::mt19937_64 random(8);
  const std::vector<double> targets = equal_targets(5, 100.0);
  const axiometry::Test test = tested([](double x) { return 0.02 * x; }, targets, 5, random);
  const AxisCorrection old = *AxisCorrection::make(AxisKind::linear, {0.0, 250.0, 400.0}, {0, 30, 0}, {0, 30, 0});
  const auto same = compensated_positions(test, {old, old, &old});
  const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
  const auto without = compensated_positions(test, {none, none});
  for (std::size_t i = 0; i < targets.size(); ++i)
    EXPECT_NEAR(same->targets[i].up->residual, without->targets[i].up->residual, 1e-9);
  // A table taken away bends the axis where it had a node: 0.02 · 250 − 2.5 − (30 − 11.2) µm, z among it.
  const auto bent = compensated_positions(test, {none, none, &old});
  EXPECT_NEAR(bent->gaps[0][2].residual, -16.3, 1.2);
  EXPECT_LT(bent->gaps[0][2].residual, bent->targets[2].up->residual);
}

}  // namespace
}  // namespace axiometry::compensation
