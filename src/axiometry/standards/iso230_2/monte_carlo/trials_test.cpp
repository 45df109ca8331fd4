// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/trials.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "axiometry/standards/iso230_2/monte_carlo/noise.h"
#include "axiometry/standards/readings/test_course.h"
#include "tests/support/series.h"
#include "tests/support/statistics_of_trials.h"
#include "tests/support/two_samples.h"

namespace axiometry::iso230_2 {
namespace {

namespace table2 = testing_support::table2;
using testing_support::none;

constexpr std::size_t drawn_trials = 400;

std::vector<double> drawn(const TrialModel& model) {
  std::vector<double> values(model.output_count() * drawn_trials);
  model(3, {values, drawn_trials});
  return values;
}

/// The parameters of a series as figures of a trial, evaluated one by one; of single readings, these are made.
TrialFigures parameters_as_figures(const Series& series, std::span<const ParameterInfo* const> wanted,
                                   bool of_single_readings = true) {
  TrialFigures figures;
  const Evaluation measured = evaluate(series);
  for (const ParameterInfo* parameter : wanted) {
    const bool between_places =
        parameter->key.starts_with('A') || parameter->key.starts_with('E') || parameter->key.starts_with('M');
    figures.figures.push_back(
        {(measured.parameters.*parameter->member)->in_native(), between_places, of_single_readings});
  }
  figures.evaluate = [wanted = std::vector(wanted.begin(), wanted.end())](const Series& trial, const WantedFigures&,
                                                                          std::span<double> values) {
    const Evaluation found = evaluate(trial);
    for (std::size_t k = 0; k < wanted.size(); ++k) values[k] = (found.parameters.*wanted[k]->member)->in_native();
  };
  return figures;
}

void expect_same_trials(const Series& series, const UncertaintyInputs& inputs, const NoiseModel& noise) {
  TrialModelOptions options;
  const TrialModel by_moments(series, inputs, noise, options);
  const TrialFigures figures = parameters_as_figures(series, by_moments.outputs());
  options.figures = &figures;
  const TrialModel by_readings(series, inputs, noise, options);
  const std::vector<double> expected = drawn(by_readings), found = drawn(by_moments);
  ASSERT_EQ(found.size(), expected.size());
  double varied = 0.0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    ASSERT_EQ(found[k], expected[k]) << noise.hypothesis.key << ", value " << k;
    varied = std::max(varied, std::abs(found[k] - found[k / drawn_trials * drawn_trials]));
  }
  EXPECT_GT(varied, 0.0) << noise.hypothesis.key;
}

/// Of trials whose readings are never made and of others whose readings are: every parameter, and of every pair of
/// them the correlation.
void expect_same_distribution(const Series& series, const UncertaintyInputs& inputs, const NoiseModel& noise) {
  TrialModelOptions options;
  const TrialModel by_moments(series, inputs, noise, options);
  const TrialFigures figures = parameters_as_figures(series, by_moments.outputs());
  options.figures = &figures;
  options.seed = 2;
  const TrialModel by_readings(series, inputs, noise, options);
  constexpr std::size_t trials = 2 * uncertainty::block_size;
  const auto draw = [&](const TrialModel& model) {
    std::vector<std::vector<double>> rows(model.output_count());
    std::vector<double> values(model.output_count() * uncertainty::block_size);
    for (std::uint64_t block = 0; block * uncertainty::block_size < trials; ++block) {
      model(block, {values, uncertainty::block_size});
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto own = std::span(values).subspan(k * uncertainty::block_size, uncertainty::block_size);
        rows[k].insert(rows[k].end(), own.begin(), own.end());
      }
    }
    return rows;
  };
  const auto found = draw(by_moments), expected = draw(by_readings);
  std::vector<std::vector<double>> ranks, expected_ranks;
  for (std::size_t k = 0; k < found.size(); ++k) {
    SCOPED_TRACE(noise.hypothesis.key + ", " + std::string(by_moments.outputs()[k]->key));
    const auto own = testing_support::sample_moments(found[k]), other = testing_support::sample_moments(expected[k]);
    EXPECT_GT(own.variance, 0.0);
    EXPECT_LT(testing_support::mean_departure(own, other, trials), testing_support::million_to_one_of_z);
    EXPECT_LT(testing_support::variance_departure(own, other, trials), testing_support::million_to_one_of_z);
    EXPECT_LT(testing_support::two_sample_distance(found[k], expected[k]), testing_support::million_to_one);
    ranks.push_back(testing_support::standard_ranks(found[k]));
    expected_ranks.push_back(testing_support::standard_ranks(expected[k]));
  }
  for (std::size_t a = 0; a < ranks.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      double difference = 0.0;
      for (std::size_t t = 0; t < trials; ++t)
        difference += (ranks[a][t] * ranks[b][t] - expected_ranks[a][t] * expected_ranks[b][t]) / double(trials);
      EXPECT_LT(std::abs(difference), testing_support::million_to_one_of_z * std::sqrt(2.0 / double(trials)))
          << a << ", " << b;
    }
}

UncertaintyInputs errors_of_length() {
  UncertaintyInputs inputs;
  inputs.inputs.push_back({"calibration",
                           "b",
                           "Calibration",
                           "1",
                           Effect::scale,
                           uncertainty::Distribution::parse("normal 0 0.5").value(),
                           "µm/m",
                           {}});
  return inputs;
}

Series series_with_gaps() {
  return testing_support::make_series({0, 10, 20}, {{1, 2, 3}, {1.5, none, 3.5}, {0.5, 2.5, 2.5}},
                                      {{4, 5, none}, {4.5, 5.5, none}, {3.5, 4.5, none}});
}

/// Figures of means and s are those of the trials of the parameters, those of single readings beside them are not.
TEST(TrialModel, GivesFiguresOfMomentsTheTrialsOfTheParameters) {
  for (const Series& series : {table2::series(), series_with_gaps()}) {
    const NoiseModel noise{{.key = "stated"}, {ReadingNoise{.reading = 0.3}}, nullptr};
    const UncertaintyInputs inputs = errors_of_length();
    TrialModelOptions options;
    const TrialModel of_parameters(series, inputs, noise, options);
    TrialFigures figures = parameters_as_figures(series, of_parameters.outputs(), false);
    figures.figures.back().of_single_readings = true;
    options.figures = &figures;
    const TrialModel of_figures(series, inputs, noise, options);
    const std::vector<double> expected = drawn(of_parameters), found = drawn(of_figures);
    const std::size_t shared = found.size() - drawn_trials;
    for (std::size_t k = 0; k < shared; ++k) ASSERT_NEAR(found[k], expected[k], 1e-12) << k;
    ASSERT_NE(found[shared], expected[shared]);
    ASSERT_NE(found[shared], found[shared + 1]);
  }
}

TEST(TrialModel, DrawsTheSameByMomentsOfCellsAsByReadings) {
  const Series complete = table2::series(), gaps = series_with_gaps();
  const ReadingNoise exact{}, common{.run = 0.2, .target = 0.1, .up_down_correlation = -0.5, .target_direction = 0.1};
  for (const Series* series : {&complete, &gaps})
    for (const ReadingNoise& noise : {exact, common})
      expect_same_trials(*series, errors_of_length(), {{.key = "stated"}, {noise}, nullptr});
}

TEST(TrialModel, HasTheSameDistributionWithoutReadingsWhereEachHasNoise) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  const Series complete = table2::series(), gaps = series_with_gaps();
  const ReadingNoise small{.reading = 0.05}, white{.reading = 0.3},
      all{.reading = 0.3, .run = 0.2, .target = 0.1, .up_down_correlation = -0.5, .target_direction = 0.1};
  for (const Series* series : {&complete, &gaps})
    for (const ReadingNoise& noise : {small, white, all})
      expect_same_distribution(*series, errors_of_length(), {{.key = "stated"}, {noise}, nullptr});
}

/// Of shares that have noise of single readings and of one that has none.
TEST(TrialModel, HasTheSameDistributionBesideADrift) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  axiometry::Test test{{}, table2::series(), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(1.7);
  const UncertaintyInputs inputs = uncertainty_inputs(test.metadata, test.series).value();
  const TestCourse course = course_of(test);
  std::size_t drifts = 0;
  for (const NoiseModel& noise : noise_models({test.metadata, test.series, course, inputs}).models) {
    if (!noise.drift) continue;
    ++drifts;
    expect_same_distribution(test.series, inputs, noise);
    NoiseModel still = noise;
    still.shares = {ReadingNoise{}};
    expect_same_trials(test.series, inputs, still);
  }
  EXPECT_GE(drifts, 2u);
}

TEST(TrialModel, DrawsTheSameFromAnUncertainStation) {
  UncertaintyInputs inputs = errors_of_length();
  inputs.station = Position::native(-800.0);
  inputs.inputs.push_back({"station",
                           "Δ",
                           "Station",
                           "1",
                           Effect::station,
                           uncertainty::Distribution::parse("normal 0 2").value(),
                           "mm",
                           {}});
  expect_same_trials(table2::series(), inputs, {{.key = "stated"}, {ReadingNoise{.run = 0.2}}, nullptr});
  expect_same_distribution(table2::series(), inputs, {{.key = "stated"}, {ReadingNoise{.reading = 0.2}}, nullptr});
}

}  // namespace
}  // namespace axiometry::iso230_2
