// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/compensated_positions.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "axiometry/compensation/fit.h"
#include "axiometry/model/fields.h"
#include "tests/support/series.h"

namespace axiometry::compensation {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
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

/// Each axis measured by an instrument whose scale is off by `scale_sd` µm/m or so.
Coverage coverage_of(const std::vector<double>& nodes, std::size_t axes, std::uint64_t seed, double scale_sd = 0.0) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> scatter(0.0, scatter_of_them);
  const std::vector<double> targets = equal_targets(11, 50.0);
  Coverage found;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const Curve curve = any_axis(random);
    const double scale = scale_sd > 0.0 ? 1e-3 * std::normal_distribution<double>(0.0, scale_sd)(random) : 0.0;
    axiometry::Test test = tested([&](double x) { return curve(x) + scale * x; }, targets, 5, random);
    if (scale_sd > 0.0) test.metadata.gum.distributions = {{"scale:laser", fmt::format("normal 0 {}", scale_sd)}};
    const auto fit = fit_correction(test.series, AxisKind::linear, {.nodes = nodes, .curves = TableCurves::each_way});
    EXPECT_TRUE(fit);
    const AxisCorrection table = rounded(fit->correction);
    const auto known = compensated_positions(test, {table, fit->correction});
    EXPECT_TRUE(known);
    const auto truth = [&](double x, Direction d) {
      return curve(x) + (d == Direction::up ? 0.0 : reversal_of_them) + table.at(x, d);
    };
    const double zero = known->zero;  // the number that is printed, not the mean of what is true
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

/// At the datum a scale does nothing, but what it does to the mean of all is there too, where that were the zero.
TEST(CompensatedPositions, HoldAgainstTheZeroThatIsPrintedWhereTheScaleIsOff) {
  const Coverage found = coverage_of(equal_targets(11, 50.0), 400, 23, 20.0);
  // All targets of an axis share its scale: 400 of them, three standard deviations of the binomial are 3.1 %.
  EXPECT_NEAR(found.means.value(), 0.9545, 0.032);
  EXPECT_NEAR(found.approaches.value(), 0.9545, 0.032);
  EXPECT_GT(found.between.value(), 0.9545 - 0.032);
}

/// Every place its own, targets and a place close beside each of them: the variance of one from the line between the
/// others is 1.5 τ², as (10) sees it, and that of such a place 2 τ².
TEST(CompensatedPositions, HoldBesideTargetsWhereEveryPlaceIsItsOwn) {
  std::mt19937_64 random(24);
  std::normal_distribution<double> anything(0.0, 5.0), scatter(0.0, scatter_of_them);
  const std::vector<double> targets = equal_targets(41, 10.0);
  const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
  Share between;
  for (int axis = 0; axis < 200; ++axis) {
    std::vector<double> rough(targets.size());
    for (double& x : rough) x = anything(random);
    const auto at = [&](double x) { return rough[static_cast<std::size_t>(std::lround(x / 10.0))]; };
    const auto known = compensated_positions(tested(at, targets, 5, random), {none, none});
    ASSERT_TRUE(known);
    for (std::size_t k = 0; k + 1 < targets.size(); ++k) {
      // From the line, 2 % of the gap behind its first target.
      const double line = 0.98 * known->targets[k].up->residual + 0.02 * known->targets[k + 1].up->residual;
      const double place = anything(random) + scatter(random) - known->zero;
      between.see(place - line, known->gaps[0][k].approach->U.in_native());
    }
  }
  EXPECT_GE(between.value(), 0.95) << "with 1.5 τ² in place of 2 τ²: 0.92";
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
  EXPECT_NEAR(q_of(at), 2.0 * std::sqrt(2.0), 0.9) << "each target its own, and places beside them too";
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
  EXPECT_THAT(known->notes, Contains(HasSubstr("calibration of the instrument is not in U")));
  EXPECT_THAT(known->notes, Contains(HasSubstr("temperatures and expansion of the machine are not in U")));
  EXPECT_THAT(known->notes, Contains(HasSubstr("the alignment is not in U")));
  EXPECT_THAT(known->notes, Contains(HasSubstr("repeats from target to target alike")));
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
  EXPECT_THAT(with->notes, Not(Contains(HasSubstr("calibration of the instrument"))));
  EXPECT_THAT(with->notes, Contains(HasSubstr("temperatures and expansion of the machine are not in U")));
  EXPECT_THAT(with->notes, Contains(HasSubstr("the alignment is not in U")));
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
  EXPECT_THAT(drifting->notes, Contains(HasSubstr("part of the scatter and not counted again"))) << "of gum()";
  EXPECT_THAT(drifting->notes, Not(Contains(HasSubstr("The parameters are extremes")))) << "nothing of parameters";
  EXPECT_THAT(drifting->notes, Contains(HasSubstr("calibration of the instrument is not in U")));
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
  EXPECT_THAT(once->notes, Contains(HasSubstr("it takes two approaches")));
  const auto two = compensated_positions(tested(line, equal_targets(2, 100.0), 5, random), {none, none});
  ASSERT_TRUE(two);
  EXPECT_TRUE(two->at_targets);
  EXPECT_FALSE(two->anywhere) << "two targets do not tell what is between them";
  EXPECT_FALSE(two->between_targets[0]);
  EXPECT_THAT(two->notes, Contains(HasSubstr("it takes three of them")));
}

double largest_at_targets(const CompensatedPositions& known) {
  double most = 0.0;
  for (const CompensatedTarget& target : known.targets)
    for (const auto& side : {target.up, target.down})
      most = std::max(most, std::abs(side->residual) + side->approach->U.in_native());
  return most;
}

/// Straight, with a scatter that is the same in every build; one reading off by `error`, that of ↑ in run 3 at 300 mm.
axiometry::Test calm(double error = 0.0) {
  constexpr std::array scatter{0.4, -0.3, 0.1, -0.5, 0.2};
  const std::vector<double> targets = equal_targets(5, 100.0);
  std::vector<RunDeviations> up(5), down(5);
  for (std::size_t j = 0; j < 5; ++j)
    for (std::size_t i = 0; i < targets.size(); ++i) {
      up[j].push_back(scatter[(i + j) % 5]);
      down[j].push_back(scatter[(i + 2 * j) % 5] + reversal_of_them);
    }
  up[2][3] += error;
  return {Metadata{}, make_series(targets, up, down), {}};
}

TEST(CompensatedPositions, TellWhatWasNotCorrected) {
  const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
  axiometry::Test test = calm();
  const auto plain = compensated_positions(test, {none, none});
  ASSERT_TRUE(plain && plain->at_targets && plain->anywhere);
  EXPECT_DOUBLE_EQ(*plain->at_targets, largest_at_targets(*plain));
  // 12 µm/(m·°C) · 6 °C · 0.4 m, of which nobody said whether it was corrected.
  ASSERT_TRUE(set_field_text(test.metadata, "sensors", "machine | bed | 26 | 26"));
  const auto warm = compensated_positions(test, {none, none});
  ASSERT_TRUE(warm && warm->at_targets && warm->anywhere);
  EXPECT_THAT(warm->notes, Contains(HasSubstr("about 28.8 µm over the travel")));
  EXPECT_THAT(warm->notes, Contains(HasSubstr("is added to the largest")));
  EXPECT_NEAR(*warm->at_targets, largest_at_targets(*warm) + 28.8, 1e-9);
  EXPECT_GT(*warm->anywhere, 28.8);
  test.metadata.nde.datum = Position::native(-400.0);  // to the farthest target it is twice the travel
  const auto far = compensated_positions(test, {none, none});
  ASSERT_TRUE(far && far->at_targets);
  EXPECT_NEAR(*far->at_targets, largest_at_targets(*far) + 57.6, 1e-9);
  test.metadata.instrument.sign_reversed = true;  // nobody knows what that does
  const auto turned = compensated_positions(test, {none, none});
  ASSERT_TRUE(turned) << turned.error().message;
  EXPECT_FALSE(turned->at_targets);
  EXPECT_FALSE(turned->anywhere);
  EXPECT_TRUE(turned->targets[0].up->approach) << "U of the target is what it is";
  EXPECT_THAT(turned->notes, Contains(HasSubstr("the reversed sign of the instrument is neither corrected")));
  EXPECT_THAT(turned->notes, Contains(HasSubstr("nobody knows how large")));
}

TEST(CompensatedPositions, SayNothingWhereAReadingIsAGrossError) {
  const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
  const auto wrong = compensated_positions(calm(40.0), {none, none});
  ASSERT_TRUE(wrong);
  EXPECT_FALSE(wrong->at_targets);
  EXPECT_FALSE(wrong->anywhere);
  EXPECT_THAT(wrong->notes, Contains(HasSubstr("↑ of run 3 at 300 mm departs by ")));
  EXPECT_THAT(wrong->notes, Contains(HasSubstr("no scatter explains all of the readings")));
}

/// Targets after formula (1) of 5.3.2, with a random part of 30 % of the interval either way.
TEST(CompensatedPositions, HoldBetweenTargetsAsTheStandardHasThem) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(-30.0, 30.0);
  const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
  for (int axis = 0; axis < 20; ++axis) {
    std::vector<double> targets;
    for (int i = 0; i < 11; ++i) targets.push_back(100.0 * i + part(random));
    std::ranges::sort(targets);
    const auto known =
        compensated_positions(tested([](double x) { return 0.01 * x; }, targets, 5, random), {none, none});
    ASSERT_TRUE(known);
    for (const CompensatedGap& gap : known->gaps[0]) EXPECT_TRUE(gap.approach);
  }
}

TEST(CompensatedPositions, SayNothingOfAGapThatIsWiderThanTheOthers) {
  std::mt19937_64 random(10);
  std::vector<double> targets = equal_targets(11, 10.0);
  targets.push_back(600.0);
  // Straight where targets are near, with a bow of 50 µm between the last two.
  const auto curve = [](double x) {
    return x <= 100.0 ? 0.0 : 50.0 * std::sin(std::numbers::pi * (x - 100.0) / 500.0);
  };
  const AxisCorrection none = *AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0});
  const auto known = compensated_positions(tested(curve, targets, 5, random), {none, none});
  ASSERT_TRUE(known) << known.error().message;
  EXPECT_TRUE(known->gaps[0][9].approach);
  EXPECT_FALSE(known->gaps[0][10].approach);
  EXPECT_TRUE(known->targets[11].up->approach);
  EXPECT_FALSE(known->anywhere);
  EXPECT_THAT(known->notes, Contains(HasSubstr("over twice as far apart as they are")));
  targets.back() = 119.0;
  const auto near = compensated_positions(tested(curve, targets, 5, random), {none, none});
  ASSERT_TRUE(near);
  EXPECT_TRUE(near->gaps[0][10].approach);
  EXPECT_THAT(near->notes, Not(Contains(HasSubstr("over twice as far"))));
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
