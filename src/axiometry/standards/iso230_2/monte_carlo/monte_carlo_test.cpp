// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "axiometry/standards/iso230_2/monte_carlo/trials.h"
#include "tests/support/series.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::iso230_2 {
namespace {

namespace table2 = testing_support::table2;
using uncertainty::Distribution;

constexpr std::size_t A = 0, E = 3, R = 7, R_up = 8, B = 10;

UncertaintyInput input(Effect effect, uncertainty::Distribution::Form form) {
  return {"x", "x", "x", "", effect, *Distribution::make(std::move(form)), "", ""};
}

MonteCarloOptions options(std::size_t trials, unsigned threads = 1) {
  MonteCarloOptions chosen;
  chosen.propagation.trials = trials;
  chosen.propagation.threads = threads;
  chosen.contribution_trials = 2000;
  return chosen;
}

Metadata with_inputs(std::vector<InputDistribution> distributions) {
  Metadata metadata;
  metadata.gum.distributions = std::move(distributions);
  return metadata;
}

MonteCarlo run(const Metadata& metadata, const Series& series, const MonteCarloOptions& chosen) {
  auto result = monte_carlo(axiometry::Test{metadata, series, {}}, evaluate(series), chosen);
  if (!result || !*result) throw std::logic_error(result ? "nothing" : result.error().message);
  return **std::move(result);
}

TEST(PositioningMonteCarlo, SaysNothingWhereNothingIsKnown) {
  const Series series = table2::series();
  const auto result = monte_carlo(axiometry::Test{{}, series, {}}, evaluate(series), options(1000));
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->has_value());
}

TEST(PositioningMonteCarlo, PropagatesAScaleErrorAsItIs) {
  const Series series = table2::series();
  const MonteCarlo result = run(with_inputs({{"scale:laser", "normal 0 2"}}), series, options(20000));
  // M = the range of the mean deviations: 1.47 µm at 353.8 mm, −2.43 µm at 1 055.9 mm. The ends stay active for
  // small errors, so u(M) is about 2 µm/m · 0.70 m at first, and grows as the far end takes over.
  const auto& M = *result.distributions[6];
  EXPECT_NEAR(M.value, evaluate(series).parameters.M->in_native(), 1e-12);
  EXPECT_GT(M.summary.sd, 1.0);
  EXPECT_LT(M.summary.sd, 2.0 * 1.75);
}

/// A scale error has no part in B and R. What rounding makes of them is no uncertainty that a verdict could rest on.
TEST(PositioningMonteCarlo, ClaimsNothingAboutParametersThatNoInputActsOn) {
  const Series series = table2::series();
  const MonteCarlo result = run(with_inputs({{"scale:laser", "normal 0 2"}}), series, options(20000));
  for (std::size_t k : {R, R_up, B}) EXPECT_FALSE(result.distributions[k]) << parameters[k].key;
  EXPECT_THAT(result.notes, testing::Contains(testing::HasSubstr("No given input acts on R, R↑, R↓, B, B̄")));
  for (double u : {result.contributions[0].u[R], result.contributions[0].u[B]}) EXPECT_EQ(u, 0.0);
}

/// Before, rounding of B and R alone kept an adaptive run going to its last trial.
TEST(PositioningMonteCarlo, StopsWhereOnlyRoundingIsNotStable) {
  const Series series = table2::series();
  MonteCarloOptions adaptive = options(0);
  adaptive.propagation.trials.reset();
  adaptive.propagation.trials_max = 400'000;
  adaptive.propagation.digits = 1;
  const MonteCarlo result = run(with_inputs({{"scale:laser", "normal 0 2"}}), series, adaptive);
  EXPECT_TRUE(result.stable);
  EXPECT_LT(result.trials, 400'000u);
}

TEST(PositioningMonteCarlo, IsTheSameToTheBitOnAnyNumberOfThreads) {
  const Series series = table2::series();
  const Metadata metadata =
      with_inputs({{"reading", "normal 0 0.3"}, {"scale", "uniform -3 3"}, {"run", "normal 0 0.2"}});
  const MonteCarlo one = run(metadata, series, options(25000, 1));
  const MonteCarlo two = run(metadata, series, options(25000, 2));
  for (std::size_t p = 0; p < std::size(parameters); ++p) {
    EXPECT_EQ(one.distributions[p]->summary.mean, two.distributions[p]->summary.mean);
    EXPECT_EQ(one.distributions[p]->summary.sd, two.distributions[p]->summary.sd);
    EXPECT_EQ(one.distributions[p]->summary.symmetric.upper, two.distributions[p]->summary.symmetric.upper);
    EXPECT_EQ(one.distributions[p]->summary.shortest.lower, two.distributions[p]->summary.shortest.lower);
  }
}

TEST(PositioningMonteCarlo, OtherSeedsAgreeWithinTheStatedErrors) {
  const Series series = table2::series();
  const Metadata metadata = with_inputs({{"reading", "normal 0 0.3"}});
  MonteCarloOptions other = options(40000);
  other.seed = 77;
  const MonteCarlo first = run(metadata, series, options(40000));
  const MonteCarlo second = run(metadata, series, other);
  EXPECT_NE(first.distributions[A]->summary.mean, second.distributions[A]->summary.mean);
  EXPECT_NEAR(first.distributions[A]->summary.mean, second.distributions[A]->summary.mean,
              6 * first.distributions[A]->summary.mean_error);
}

TEST(PositioningMonteCarlo, ShowsThatNoiseHasRaisedTheExtremes) {
  const Series series = table2::series();
  const MonteCarlo result = run(with_inputs({{"reading", "normal 0 0.3"}}), series, options(20000));
  EXPECT_GT(result.distributions[R_up]->bias(), 0.0);
  EXPECT_GT(result.distributions[A]->bias(), 0.0);
}

TEST(PositioningMonteCarlo, LetsDirectionsDifferWhereTheyAreNotCorrelated) {
  const Series series = table2::series();
  const auto u_of_B = [&](double correlation) {
    Metadata metadata = with_inputs({{"target", "normal 0 2"}});
    metadata.gum.up_down_correlation = correlation;
    const auto of_B = run(metadata, series, options(5000)).distributions[B];
    return of_B ? of_B->summary.sd : 0.0;
  };
  EXPECT_EQ(u_of_B(1.0), 0.0);
  EXPECT_GT(u_of_B(0.0), 0.3);
  EXPECT_GT(u_of_B(-1.0), u_of_B(0.0));
}

/// JCGM 101, 6.4.9.2 for the mean of n readings: u² = (n − 1)/(n − 3) s²/n.
TEST(PositioningMonteCarlo, ScalesByStudentWhereAsked) {
  const Series series = testing_support::make_series(
      {0, 100}, {{0, 1000}, {1, 1001}, {2, 1003}, {3, 1003}, {4, 1003}, {5, 1005}, {6, 1006}}, {});
  Metadata metadata;
  metadata.gum.measurand = Measurand::this_machine;
  MonteCarloOptions chosen = options(200000);
  chosen.type_a = TypeA::t_scaled;
  const MonteCarlo result = run(metadata, series, chosen);
  double variance = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto position = evaluate_positions(series)[i];
    variance += std::pow(position.s_up->in_native(), 2) / 7.0 * 6.0 / 4.0;
  }
  EXPECT_NEAR(result.distributions[4]->summary.sd, std::sqrt(variance), 0.02);  // E↑, the difference of two means
}

/// A cell of one reading has no t distribution, however many readings others have.
TEST(PositioningMonteCarlo, RefusesStudentWhereACellHasTooFewReadings) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Series series =
      testing_support::make_series({0, 100}, {{0, 1000}, {1, none}, {2, none}, {3, none}, {4, none}}, {});
  Metadata metadata;
  metadata.gum.measurand = Measurand::this_machine;
  MonteCarloOptions chosen = options(1000);
  chosen.type_a = TypeA::t_scaled;
  const auto refused = monte_carlo({metadata, series, {}}, evaluate(series), chosen);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            "found 1 approach per direction, expected at least 4 for the t distribution to have a standard deviation; "
            "'pooled' needs two");
}

TEST(PositioningMonteCarlo, ResamplesWholeRuns) {
  const Series series =
      testing_support::make_series({0, 100}, {{0, 10}, {5, 15}, {9, 19}}, {{1, 11}, {6, 16}, {10, 20}});
  Metadata metadata;
  metadata.gum.measurand = Measurand::this_machine;
  MonteCarloOptions chosen = options(1000);
  chosen.type_a = TypeA::resampled;
  const MonteCarlo result = run(metadata, series, chosen);
  EXPECT_FALSE(result.distributions[E]);  // runs differ by shifts alone
  EXPECT_GT(result.distributions[R_up]->summary.sd, 0.1);
}

/// u² of the difference of two targets' means: 2 u² on top of Student's own.
TEST(PositioningMonteCarlo, KeepsErrorsOfTargetsInEveryWayOfSampling) {
  const Series series = testing_support::make_series(
      {0, 100}, {{0, 1000}, {1, 1001}, {2, 1003}, {3, 1003}, {4, 1003}, {5, 1005}, {6, 1006}}, {});
  for (TypeA type_a : {TypeA::pooled, TypeA::t_scaled, TypeA::resampled}) {
    MonteCarloOptions chosen = options(50000);
    chosen.type_a = type_a;
    const auto variance_of = [&](const Metadata& metadata) {
      return std::pow(run(metadata, series, chosen).distributions[4]->summary.sd, 2);  // E↑
    };
    Metadata none;
    none.gum.measurand = Measurand::this_machine;
    for (std::string_view key : {"target", "target_direction"}) {
      Metadata metadata = with_inputs({{std::string(key), "normal 0 3"}});
      metadata.gum.measurand = Measurand::this_machine;
      EXPECT_NEAR(variance_of(metadata), variance_of(none) + 2 * 9.0, 0.6) << type_a_key(type_a) << " " << key;
    }
  }
}

/// Where only a scale error varies, the angle stays at its estimate and moves nothing.
TEST(PositioningMonteCarlo, KeepsTheAlignmentAtItsEstimateWhereAnotherInputVaries) {
  const Series series = table2::series();
  UncertaintyInputs inputs;
  inputs.inputs.push_back(input(Effect::alignment, uncertainty::Uniform{-1.0, 1.0}));
  inputs.inputs.push_back(input(Effect::scale, uncertainty::Constant{0.0}));
  const NoiseModel exact{{}, {ReadingNoise{}}, nullptr};
  const TrialModel model(series, inputs, exact, {Measurand::this_test, TypeA::pooled, 1, true, 1});
  std::vector<double> outputs(std::size(parameters) * 100);
  model(0, {outputs, 100});
  EXPECT_NEAR(outputs[0], evaluate(series).parameters.A->in_native(), 1e-9);
}

TEST(PositioningMonteCarlo, ContributionsNameEveryInput) {
  const Series series = table2::series();
  Metadata metadata = with_inputs({{"reading", "normal 0 0.3"}, {"scale:laser", "normal 0 2"}});
  metadata.gum.measurand = Measurand::this_machine;
  const MonteCarlo result = run(metadata, series, options(2000));
  ASSERT_EQ(result.contributions.size(), 3u);
  EXPECT_EQ(result.contributions.back().key, "sampling");
  EXPECT_GT(result.contributions.back().u[R_up], 0.0);
  // The noise is in the scatter, which sampling counts.
  EXPECT_EQ(result.contributions.front().u[R_up], 0.0);
  EXPECT_THAT(result.notes, testing::Contains(std::string(scatter_note)));
}

TEST(PositioningMonteCarlo, RefusesThisMachineForASingleApproach) {
  const Series series = testing_support::make_series({0, 10, 20}, {{0, 1, 2}}, {{1, 2, 3}});
  Metadata metadata;
  metadata.gum.measurand = Measurand::this_machine;
  const auto result = monte_carlo(axiometry::Test{metadata, series, {}}, evaluate(series), options(1000));
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, testing::HasSubstr("single approach"));
}

TEST(PositioningMonteCarlo, RefusesNoiseOfInfiniteVariance) {
  const Series series = table2::series();
  const auto result = monte_carlo(axiometry::Test{with_inputs({{"reading", "t 2 0 0.1"}}), series, {}},
                                  evaluate(series), options(1000));
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, testing::HasSubstr("standard deviation"));
}

/// Validation: 400 simulated tests, of which the truth is known (docs/studies/coverage.md has 10 000).
TEST(PositioningMonteCarlo, HoldsTheTruthInNinetyFivePercent) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  constexpr std::size_t simulations = 400, trials = 400, m = 7, n = 5;
  std::array<double, std::size(parameters)> held{};
  for (std::size_t k = 0; k < simulations; ++k) {
    std::vector<double> z(4 * m * n + n);
    numeric::fill_normal({5, 0, k}, z);
    std::vector<Position> targets;
    std::vector<double> truth(2 * m * n), seen(2 * m * n);
    for (std::size_t i = 0; i < m; ++i) targets.push_back(Position::native(100.0 * double(i)));
    for (std::size_t c = 0; c < 2 * m; ++c) {
      const double x = double(c % m);
      const double mean = 4 * std::sin(0.9 * x) + 0.5 * x + (c < m ? 0.0 : 2.0 + 0.5 * std::cos(x));
      for (std::size_t j = 0; j < n; ++j) {
        truth[c * n + j] = mean + 0.7 * z[c * n + j];
        seen[c * n + j] = truth[c * n + j] + 0.7 * z[2 * m * n + c * n + j];  // noise as large as the scatter
      }
    }
    const Series series = *Series::make_dense(targets, n, seen);
    const UncertaintyInputs inputs;
    const NoiseModel noise{{}, {ReadingNoise{.reading = 0.7}}, nullptr};
    const TrialModel model(series, inputs, noise, {Measurand::this_test, TypeA::pooled, k + 1, true, std::nullopt});
    std::vector<double> outputs(std::size(parameters) * trials);
    model(0, {outputs, trials});
    const AxisParameters true_parameters = evaluate(*Series::make_dense(targets, n, truth)).parameters;
    for (std::size_t p = 0; p < std::size(parameters); ++p) {
      const auto row = std::span(outputs).subspan(p * trials, trials);
      std::ranges::sort(row);
      const double value = (true_parameters.*parameters[p].member)->in_native();
      held[p] += row[trials / 40] <= value && value <= row[trials - trials / 40];
    }
  }
  for (std::size_t p = 0; p < std::size(parameters); ++p)
    EXPECT_NEAR(held[p] / double(simulations), 0.95, 0.045) << parameters[p].key;
}

}  // namespace
}  // namespace axiometry::iso230_2
