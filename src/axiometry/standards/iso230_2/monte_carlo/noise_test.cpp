// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/noise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::size_t at_A = 0, at_R = 7;

axiometry::Test table2_with(std::optional<EnvironmentKind> kind, double range_um = 1.7) {
  axiometry::Test test{{}, testing_support::table2::series(), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(range_um);
  test.metadata.gum.environment_kind = kind;
  return test;
}

NoiseModels models_of(const axiometry::Test& test) {
  const UncertaintyInputs inputs = uncertainty_inputs(test.metadata, test.series).value();
  const TestCourse course = course_of(test);
  return noise_models({test.metadata, test.series, course, inputs});
}

std::vector<std::string> keys(const NoiseModels& models) {
  std::vector<std::string> found;
  for (const NoiseModel& model : models.models) found.push_back(model.hypothesis.key);
  return found;
}

MonteCarlo run(const axiometry::Test& test) {
  MonteCarloOptions options;
  options.propagation.trials = 4000;
  options.propagation.threads = 1;
  options.contribution_trials = 0;
  return monte_carlo(test, evaluate(test.series), options).value().value();
}

TEST(NoiseModels, RefuteWhiteNoiseInTheExampleOfTheStandard) {
  const NoiseModels models = models_of(table2_with({}));
  EXPECT_THAT(keys(models), ElementsAre("none", "drift", "drift-beside-runs", "trend-beside-runs", "random-walk",
                                        "random-walk-beside-runs"));
  ASSERT_EQ(models.hypotheses[1].key, "white");
  EXPECT_TRUE(models.hypotheses[1].refuted);
  EXPECT_LT(*models.hypotheses[1].p, 1e-20);
}

TEST(NoiseModels, TakeEveryOtherKindWhereTheStatedOneIsRefuted) {
  const NoiseModels models = models_of(table2_with(EnvironmentKind::white));
  EXPECT_THAT(keys(models), ElementsAre("none", "drift", "drift-beside-runs", "trend-beside-runs", "random-walk",
                                        "random-walk-beside-runs"));
  EXPECT_THAT(models.notes, testing::Contains(HasSubstr("stated as white noise, which the readings refute")));
}

TEST(NoiseModels, TakeAStatedKindAlone) {
  EXPECT_THAT(keys(models_of(table2_with(EnvironmentKind::drift))),
              ElementsAre("none", "drift", "drift-beside-runs", "trend-beside-runs"));
  EXPECT_THAT(keys(models_of(table2_with(EnvironmentKind::random_walk))),
              ElementsAre("none", "random-walk", "random-walk-beside-runs"));
  EXPECT_THAT(keys(models_of(table2_with(EnvironmentKind::white, 0.4))), ElementsAre("none", "white"));
  EXPECT_THAT(keys(models_of(table2_with({}, 0.4))),
              ElementsAre("none", "white", "drift", "drift-beside-runs", "trend-beside-runs", "random-walk",
                          "random-walk-beside-runs"));
}

TEST(NoiseModels, AreNoneWithoutAnyNoise) { EXPECT_THAT(keys(models_of(table2_with({}, 0.0))), ElementsAre("none")); }

TEST(NoiseModels, SayWhereStatedNoiseContradictsTheReadings) {
  axiometry::Test test{{}, testing_support::table2::series(), {}};
  test.metadata.gum.distributions = {{"reading:display", "normal 0 5"}};
  const NoiseModels models = models_of(test);
  EXPECT_THAT(models.notes, ElementsAre(HasSubstr("contradicts the readings")));
  EXPECT_LT(models.models[1].shares[0].reading, 0.3) << "no more than the readings scatter";
}

/// A worse measurement never makes a result look better: with ever more noise the interval keeps the measured value.
TEST(NoiseModels, KeepTheMeasuredValueInTheInterval) {
  for (double range : {0.1, 0.5, 1.7, 5.0, 50.0, 500.0}) {
    const MonteCarlo result = run(table2_with({}, range));
    for (std::size_t p = 0; p < std::size(parameters); ++p) {
      EXPECT_LE(result.distributions[p]->low, result.distributions[p]->value + 1e-9) << range << parameters[p].key;
      EXPECT_GE(result.distributions[p]->high, result.distributions[p]->value - 1e-9) << range << parameters[p].key;
    }
  }
}

/// Much noise and little scatter: moved back, what the noise may have made of R↑ lies on both sides of 0.
TEST(NoiseModels, StateNoRangeBelowZero) {
  const MonteCarlo result = run(table2_with({}, 8.0));
  for (std::size_t p = 0; p < std::size(parameters); ++p)
    if (parameters[p].member != &AxisParameters::B_mean)
      EXPECT_GE(result.distributions[p]->low, 0.0) << parameters[p].key;
  EXPECT_EQ(result.distributions[at_R + 1]->low, 0.0);
  EXPECT_LT(result.distributions[std::size(parameters) - 1]->low, 0.0) << "B̄ has a sign";
}

TEST(NoiseModels, StateTheEnvelopeOfAllAndWhereItsEndsComeFrom) {
  const MonteCarlo result = run(table2_with({}));
  const ParameterDistribution& d = *result.distributions[at_R];
  ASSERT_EQ(d.by_hypothesis.size(), 6u);
  double low = d.value, high = d.value;
  for (std::size_t h = 0; h < d.by_hypothesis.size(); ++h) {
    const auto& own = d.by_hypothesis[h].symmetric;
    low = std::min({low, own.lower, own.lower + d.shift_of(h)});
    high = std::max({high, own.upper, own.upper + d.shift_of(h)});
  }
  EXPECT_EQ(d.low, low);
  EXPECT_EQ(d.high, high);
  EXPECT_GT(d.high, d.value) << "noise of any size up to what is stated leaves some doubt above too";
  EXPECT_LT(result.distributions[at_A]->high - result.distributions[at_A]->low, 2 * 4.3) << "Annex A's U";
}

/// Where a whole run may have shifted by itself the environment may have hidden a part of that: what is believed of R
/// reaches above what was measured.
TEST(NoiseModels, HoldItPossibleThatShiftsOfRunsAreTheMachinesOwn) {
  const MonteCarlo result = run(table2_with(EnvironmentKind::random_walk));
  const ParameterDistribution& R = *result.distributions[at_R];
  ASSERT_EQ(R.by_hypothesis.size(), 3u);
  EXPECT_LT(R.by_hypothesis[1].mean, R.value - 0.5) << "all shifts are the environment's";
  EXPECT_GT(R.by_hypothesis[2].symmetric.upper, R.value) << "none of them need be";
}

/// A machine whose run means happen to lie level may have been lucky: a trend undid the shifts of its runs.
TEST(NoiseModels, HoldATrendPossibleThatShiftsOfTheRunsHide) {
  const std::vector<double> trend = {-0.5, 0.0, 0.5}, shifts = {0.9, 0.2, -1.1};
  std::vector<testing_support::RunDeviations> up(3), down(3), true_up(3), true_down(3);
  std::vector<double> z(6 * 9);
  numeric::fill_normal({4, 0, 0}, z);
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 9; ++i) {
      const double u = std::sin(double(i)) + 0.2 * z[j * 18 + i], d = u + 2.0 + 0.2 * z[j * 18 + 9 + i];
      true_up[j].push_back(u + shifts[j]), true_down[j].push_back(d + shifts[j]);
      up[j].push_back(u + shifts[j] + trend[j]), down[j].push_back(d + shifts[j] + trend[j]);
    }
  const std::vector<double> targets = {0, 50, 100, 150, 200, 250, 300, 350, 400};
  axiometry::Test test{{}, testing_support::make_series(targets, up, down), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(1.0);
  const MonteCarlo result = run(test);
  const double truth = evaluate(testing_support::make_series(targets, true_up, true_down)).parameters.R->in_native();
  EXPECT_GT(truth, 1.5 + result.distributions[at_R]->value);
  EXPECT_GT(result.distributions[at_R]->high, truth);
}

TEST(NoiseModels, DoubtWhatIsOpenAndSaySo) {
  const auto reason = [](const NoiseModels& models) {
    for (const NoiseHypothesis& h : models.hypotheses)
      if (h.key == "trend-beside-runs") return h.reason;
    return std::string();
  };
  const NoiseModels unknown = models_of(table2_with({}));
  const NoiseModels refuted = models_of(table2_with(EnvironmentKind::white));
  const NoiseModels stated = models_of(table2_with(EnvironmentKind::drift));
  EXPECT_THAT(reason(unknown), HasSubstr("up to five times"));
  EXPECT_THAT(reason(refuted), HasSubstr("up to five times"));
  EXPECT_THAT(reason(stated), HasSubstr("about the size that is stated"));
  EXPECT_THAT(unknown.notes, testing::Contains(HasSubstr("E_VE is open")));
  EXPECT_THAT(refuted.notes, testing::Contains(HasSubstr("E_VE is open")));
  EXPECT_THAT(stated.notes, testing::Not(testing::Contains(HasSubstr("E_VE is open"))));
}

TEST(NoiseModels, SayNothingOfRunsWhereThereIsOne) {
  axiometry::Test test{{}, testing_support::make_series({0, 10, 20}, {{1, 2, 3}}, {{2, 3, 4}}), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(1.0);
  const NoiseModels models = models_of(test);
  EXPECT_THAT(keys(models), testing::Not(testing::Contains(HasSubstr("beside-runs"))));
  EXPECT_THAT(models.notes, testing::Not(testing::Contains(HasSubstr("runs"))));
}

TEST(NoiseModels, TakeAnEnvironmentThatIsNextToNothingForNone) {
  EXPECT_THAT(keys(models_of(table2_with({}, 1e-165))), ElementsAre("none"));
}

axiometry::Test with_error_of_a_reading(const axiometry::Test& test, double error) {
  std::vector<double> readings;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < test.series.target_count(); ++i)
      for (double x : test.series.cell(i, direction)) readings.push_back(x);
  readings[5 * 8 + 2] += error;
  axiometry::Test own = test;
  own.series = Series::make_dense({test.series.targets().begin(), test.series.targets().end()}, 5, readings).value();
  return own;
}

/// The first size at which it may be one, well before no interval is stated; 0 where none is.
double first_suspected_error(const axiometry::Test& test) {
  for (double error = 0.0; error < 3.0; error += 0.05)
    for (const std::string& key : keys(models_of(with_error_of_a_reading(test, error))))
      if (key == "single-errors") return error;
  return 0.0;
}

TEST(NoiseModels, HoldAReadingThatStandsOutForAnErrorToo) {
  const axiometry::Test test = table2_with({}, 0.3);
  EXPECT_THAT(keys(models_of(test)), testing::Not(testing::Contains("single-errors")));
  const double suspected = first_suspected_error(test);
  ASSERT_GT(suspected, 0.0);
  const MonteCarlo before = run(test), result = run(with_error_of_a_reading(test, suspected));
  EXPECT_TRUE(result.distributions[at_R]->refusal.empty());
  EXPECT_LT(result.distributions[at_R]->low, before.distributions[at_R]->value);
}

/// Nothing that is stated acts on R and B then: an interval of a suspected error alone would claim to know them.
TEST(NoiseModels, KnowNothingOfSingleReadingsByAResolution) {
  const double suspected = first_suspected_error(table2_with({}, 0.3));
  ASSERT_GT(suspected, 0.0);
  axiometry::Test test = with_error_of_a_reading(table2_with({}, 0.0), suspected);
  test.metadata.gum.instrument_resolution = Deviation::native(0.1);
  EXPECT_THAT(keys(models_of(test)), ElementsAre("none", "white"));
  const MonteCarlo result = run(test);
  EXPECT_TRUE(result.distributions[at_A].has_value());
  EXPECT_FALSE(result.distributions[at_R].has_value());
}

TEST(NoiseModels, TakeAWhiteRecordingForWhiteNoiseAlone) {
  axiometry::Test test = table2_with({}, 0.4);
  std::vector<double> z(400);
  numeric::fill_normal({3, 0, 0}, z);
  for (std::size_t k = 0; k < z.size(); ++k)
    test.metadata.gum.drift_recording.push_back((k % 2 == 0 ? 0.2 : -0.2) + 0.001 * z[k]);
  test.metadata.gum.drift_interval = Duration::s(1.0);
  const NoiseModels models = models_of(test);
  EXPECT_THAT(keys(models), ElementsAre("none", "recording"));
  EXPECT_THAT(models.hypotheses[1].reason, HasSubstr("nothing beside it"));
}

TEST(NoiseModels, RefuseAnIntervalWhereAReadingIsBeyondAllScatter) {
  axiometry::Test test = table2_with({});
  std::vector<double> readings;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < test.series.target_count(); ++i)
      for (double x : test.series.cell(i, direction)) readings.push_back(x);
  readings[5 * 4 + 2] += 5.0;
  test.series = Series::make_dense({test.series.targets().begin(), test.series.targets().end()}, 5, readings).value();
  const MonteCarlo result = run(test);
  EXPECT_THAT(result.distributions[at_R]->refusal, HasSubstr("↑ of run 3 at 704.175 mm"));
  EXPECT_THAT(result.notes, testing::Contains(HasSubstr("No interval is stated")));
}

}  // namespace
}  // namespace axiometry::iso230_2
