// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/uncertainty/gum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double close = 1e-12;

Metadata with(std::vector<InputDistribution> distributions, Measurand measurand = Measurand::this_test) {
  Metadata m;
  m.gum.distributions = std::move(distributions);
  m.gum.measurand = measurand;
  return m;
}

GumUncertainty of(const Metadata& metadata, const Series& series = testing_support::table2::series()) {
  auto result = gum(axiometry::Test{metadata, series, {}}, evaluate(series));
  EXPECT_TRUE(result) << result.error().message;
  return result->value();
}

double u(const GumUncertainty& result, std::string_view key) {
  const GumParameter* parameter = result.find(key);
  return parameter ? parameter->uncertainty.u.in_native() : 0.0;
}

TEST(Gum, IsNothingWithoutInputs) {
  const Series series = testing_support::table2::series();
  EXPECT_FALSE(gum(axiometry::Test{{}, series, {}}, evaluate(series)).value());
  EXPECT_TRUE(gum(axiometry::Test{with({}, Measurand::this_machine), series, {}}, evaluate(series)).value())
      << "the approaches are known";
}

TEST(Gum, FailsAsTheInputsDo) {
  const Series series = testing_support::table2::series();
  EXPECT_FALSE(gum(axiometry::Test{with({{"scale", "normal 0"}}), series, {}}, evaluate(series)));
}

TEST(Gum, OfAScaleErrorFollowsTheDistanceOfTheExtremes) {
  const auto result = of(with({{"scale:optics", "normal 0 2"}}));
  // The largest mean of Table 2 is at targets 2 and 3 ↓ (175.077 and 353.834 mm), the smallest at target 8 ↑ (1234.304
  // mm): the longer lever counts.
  EXPECT_NEAR(u(result, "E"), 2.0 * (1234.304 - 175.077) / 1000.0, close);
  EXPECT_EQ(result.find("B"), nullptr);
  EXPECT_EQ(result.find("R"), nullptr);
  EXPECT_EQ(result.find("B_mean"), nullptr);
  EXPECT_THAT(result.notes, Contains(HasSubstr("No given input acts on R, R↑, R↓, B, B̄")));
  EXPECT_EQ(result.find("E")->uncertainty.k, 2.0);
  EXPECT_EQ(result.find("E")->uncertainty.coverage, Coverage::normal);
}

TEST(Gum, OfTargetsThatShareAnExtremeDoesNotDependOnTheLastBit) {
  const auto u_of = [](const auto& up, const auto& down) {
    return u(of(with({{"scale:optics", "normal 0 2"}, {"reading", "uniform -1 1"}}),
                testing_support::make_series(testing_support::table2::targets, up, down)),
             "E");
  };
  auto up = testing_support::table2::up;
  auto down = testing_support::table2::down;
  const double expected = u_of(up, down);
  std::ranges::sort(down);
  do {
    EXPECT_NEAR(u_of(up, down), expected, 1e-12 * expected);
  } while (std::ranges::next_permutation(down).found);
  std::mt19937 random(14);
  for (int trial = 0; trial < 50; ++trial) {
    auto changed = testing_support::table2::down;
    for (auto& run : changed)
      for (double& x : run) x = std::nextafter(x, random() % 2 ? 99.0 : -99.0);
    EXPECT_NEAR(u_of(up, changed), expected, 1e-12 * expected);
  }
}

TEST(Gum, OfAPositionDividesByTheThermalFactorWhereTheReadingsWereCorrectedAlone) {
  auto metadata = with({});
  metadata.uncertainty.machine_temperature_difference = TemperatureDifference::kelvin(10);
  metadata.uncertainty.machine_temperature_range = TemperatureDifference::kelvin(2);
  metadata.uncertainty.machine_expansion = ExpansionCoefficient::um_per_m_K(100);
  const auto thermal = [&](std::optional<bool> applied) {
    metadata.nde.applied = applied;
    return of(metadata).positions[10].up->thermal.in_native();
  };
  EXPECT_EQ(thermal(std::nullopt), thermal(false)) << "p_m is what was read";
  EXPECT_NEAR(thermal(true) / thermal(false), 1.0 + 1e-6 * 1000, 1e-9) << "p_m = (p_n + x)/f_t";
}

TEST(Gum, OfAReadingsNoiseIsThatOfMeansAndEstimators) {
  const double noise = 0.1;
  const auto result = of(with({{"reading", "normal 0 0.1"}}));
  EXPECT_NEAR(u(result, "E"), noise * std::sqrt(2.0 / 5.0), close);
  EXPECT_NEAR(u(result, "M"), noise * std::sqrt(1.0 / 5.0), close);
  EXPECT_NEAR(u(result, "B"), noise * std::sqrt(2.0 / 5.0), close);
  EXPECT_NEAR(u(result, "B_mean"), noise * std::sqrt(2.0 / 5.0 / 11.0), close);
  EXPECT_NEAR(u(result, "R_up"), 4.0 * noise / std::sqrt(4.0), close);
  EXPECT_NEAR(u(result, "R"), noise * std::sqrt(2.0 / 5.0 + 2.0 * 4.0 / 4.0), close);
  EXPECT_NEAR(u(result, "A"), noise * std::sqrt(2.0 / 5.0 + 2.0 * 4.0 / 4.0), close);
}

TEST(Gum, OfThisMachineTakesTheScatterAndNotTheNoiseToo) {
  auto result = of(with({{"reading", "normal 0 0.3"}}, Measurand::this_machine));
  const Evaluation evaluation = evaluate(testing_support::table2::series());
  const double s = evaluation.parameters.R_up->in_native() / 4.0;
  EXPECT_NEAR(u(result, "R_up"), 4.0 * s / std::sqrt(8.0), close);
  const ExpandedUncertainty& R_up = result.find("R_up")->uncertainty;
  EXPECT_NEAR(*R_up.effective_degrees_of_freedom, 4.0, 1e-9);
  EXPECT_NEAR(R_up.k, 2.8693, 1e-4) << "t for 95.45 % and ν = 4";
  EXPECT_EQ(R_up.coverage, Coverage::degrees_of_freedom);
  EXPECT_THAT(result.notes, Contains(HasSubstr("part of the scatter and not counted again")));
  EXPECT_EQ(result.sources.back().key, "approaches");
}

TEST(Gum, OfARunsDriftCancelsInRangesOfMeansAndCountsInEstimators) {
  const auto result = of(with({{"run", "normal 0 0.1"}}));
  EXPECT_EQ(result.find("E"), nullptr);
  EXPECT_EQ(result.find("B_mean"), nullptr);
  EXPECT_NEAR(u(result, "R_up"), 4.0 * 0.1 / std::sqrt(4.0), close) << "one cell: like independent noise";
  EXPECT_GT(u(result, "A"), 0.0);
  EXPECT_NEAR(result.positions[0].up->approaches.in_native(), 0.1 / std::sqrt(5.0), close);
}

TEST(Gum, OfARunsDriftOnAMachineIsTakenOutOfTheScatterOfMeans) {
  const auto plain = of(with({}, Measurand::this_machine));
  const auto drifting = of(with({{"run", "normal 0 0.2"}}, Measurand::this_machine));
  EXPECT_LT(u(drifting, "E"), u(plain, "E"));
  const ExpandedUncertainty& A = drifting.find("A")->uncertainty;
  EXPECT_EQ(A.coverage, Coverage::degrees_of_freedom) << "the drift cancels in A";
}

TEST(Gum, OfAnErrorAtEachTargetKnowsTheCorrelationOfBothDirections) {
  const auto at = [&](double r) {
    Metadata m = with({{"target", "normal 0 1"}});
    m.gum.up_down_correlation = r;
    return of(m);
  };
  EXPECT_EQ(at(1).find("B"), nullptr);
  EXPECT_NEAR(u(at(0), "B"), std::sqrt(2.0), close);
  EXPECT_NEAR(u(at(-1), "B"), 2.0, close);
  EXPECT_NEAR(u(at(0.5), "B"), 1.0, close);
  EXPECT_NEAR(u(at(1), "M"), std::sqrt(2.0), close);
  EXPECT_NEAR(u(at(0), "M"), 1.0, close);
  EXPECT_EQ(at(-1).find("M"), nullptr);
  EXPECT_NEAR(at(0.5).positions[0].mean->u.in_native(), std::sqrt(0.75), close) << "eq. 10";
  EXPECT_NEAR(u(of(with({{"target_direction", "normal 0 1"}})), "B"), std::sqrt(2.0), close);
}

TEST(Gum, StatesDegreesOfFreedomOnlyWhereNothingIsCorrelated) {
  Metadata m = with({{"target", "t 6 0 1"}});
  EXPECT_NEAR(*of(m).find("E")->uncertainty.effective_degrees_of_freedom, 6.0, 1e-9);
  m.gum.up_down_correlation = 0.5;
  const auto correlated = of(m);
  EXPECT_EQ(correlated.find("E")->uncertainty.coverage, Coverage::correlated);
  EXPECT_FALSE(correlated.find("E")->uncertainty.effective_degrees_of_freedom);
  EXPECT_THAT(correlated.notes, Contains(HasSubstr("correlated")));
}

TEST(Gum, AddsTheProductOfExpansionAndTemperatureWhereEquation15IsBlind) {
  const Metadata known = with({{"machine_expansion", "uniform 5.85 17.55"}, {"machine_temperature", "uniform -1 1"}});
  const auto result = of(known);
  EXPECT_NEAR(result.machine_thermal->u_linear, 6.75, 0.006);
  EXPECT_NEAR(result.machine_thermal->u, 7.03, 0.005);
  EXPECT_NEAR(u(result, "E"), result.machine_thermal->u * (1234.304 - 175.077) / 1000.0, 1e-9);
  EXPECT_EQ(result.sources.back().key, "machine_thermal_product");
  EXPECT_GT(result.find("E")->contributions.back().in_native(), 1.0);
}

TEST(Gum, ContributionsMakeUpTheWhole) {
  auto m = testing_support::table2::complete_test().metadata;
  m.gum.axis_resolution = Deviation::native(1);
  m.gum.run_drift = Deviation::native(0.1);
  for (Measurand measurand : {Measurand::this_test, Measurand::this_machine}) {
    m.gum.measurand = measurand;
    const auto result = of(m);
    for (const auto& parameter : result.parameters) {
      ASSERT_EQ(parameter.contributions.size(), result.sources.size());
      double squares = 0.0;
      for (Deviation x : parameter.contributions) squares += x.in_native() * x.in_native();
      EXPECT_NEAR(std::sqrt(squares), parameter.uncertainty.u.in_native(), close);
      EXPECT_NEAR(parameter.uncertainty.U.in_native(), parameter.uncertainty.k * parameter.uncertainty.u.in_native(),
                  close);
    }
  }
}

/// What the linearised scale, target, run and reading errors do, drawn and evaluated: for errors that are small against
/// everything else, the standard deviation of a parameter is its u.
TEST(Gum, IsTheSpreadOfTheEvaluationUnderSmallErrors) {
  const Metadata m = with({{"scale", "normal 0 1e-4"},
                           {"target", "normal 0 1e-4"},
                           {"run", "normal 0 2e-4"},
                           {"reading", "normal 0 1e-4"}});
  // Unlike Table 2, without two means that are equal.
  auto down = testing_support::table2::down;
  down[0][1] = 3.8;
  const Series series =
      testing_support::make_series(testing_support::table2::targets, testing_support::table2::up, down);
  const auto result = of(m, series);
  std::mt19937 random(230);
  std::normal_distribution<double> normal(0.0, 1e-4);
  constexpr int trials = 4000;
  std::vector<std::vector<double>> values(std::size(parameters));
  for (int trial = 0; trial < trials; ++trial) {
    const double scale = normal(random);
    std::vector<double> of_run(5);
    for (double& x : of_run) x = 2.0 * normal(random);
    std::vector<double> of_target(11);
    for (double& x : of_target) x = normal(random);
    std::vector<double> dense;
    for (Direction d : {Direction::up, Direction::down})
      for (std::size_t i = 0; i < 11; ++i)
        for (std::size_t j = 0; j < 5; ++j)
          dense.push_back(series.reading(i, d, j)->in_native() + scale * series.targets()[i].in_native() / 1000.0 +
                          of_run[j] + of_target[i] + normal(random));
    const Series drawn =
        Series::make_dense({series.targets().begin(), series.targets().end()}, 5, std::move(dense)).value();
    const AxisParameters p = evaluate(drawn).parameters;
    for (std::size_t k = 0; k < std::size(parameters); ++k) values[k].push_back((p.*parameters[k].member)->in_native());
  }
  for (std::size_t k = 0; k < std::size(parameters); ++k) {
    double mean = 0.0;
    double squares = 0.0;
    for (double x : values[k]) mean += x / trials;
    for (double x : values[k]) squares += (x - mean) * (x - mean) / (trials - 1);
    // Four standard errors of a standard deviation: 4/√(2 · 4000).
    EXPECT_NEAR(std::sqrt(squares) / u(result, parameters[k].key), 1.0, 0.045) << parameters[k].key;
  }
}

TEST(Gum, WorksWithASingleApproachAndOneDirection) {
  const Series series = testing_support::make_series({0, 500, 1000}, {{1, 2, 4}}, {});
  const auto result = of(with({{"reading", "normal 0 1"}}, Measurand::this_machine), series);
  EXPECT_NEAR(u(result, "E_up"), std::sqrt(2.0), close) << "the known noise is all that is known";
  EXPECT_FALSE(result.positions[0].down);
  EXPECT_FALSE(result.positions[0].mean);
  EXPECT_THAT(result.notes, Contains(HasSubstr("single approach")));
}

TEST(Gum, OnARotaryAxisHasNoFactors) {
  auto m = testing_support::table2::complete_test().metadata;
  m.axis.kind = AxisKind::rotary;
  m.uncertainty.device_calibration = Deviation::native(2);
  const auto result = of(m);
  EXPECT_FALSE(result.machine_thermal);
  EXPECT_FALSE(result.alignment);
  EXPECT_NEAR(result.positions[3].up->instrument.in_native(), 1.0, close);
  EXPECT_GT(u(result, "E"), std::sqrt(2.0) - close);
}

}  // namespace
}  // namespace axiometry::iso230_2
