// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/trials.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "axiometry/standards/iso230_2/monte_carlo/noise.h"
#include "axiometry/standards/readings/test_course.h"
#include "tests/support/series.h"

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

/// The parameters of a series as figures of a trial, so that every trial's readings are made and evaluated one by one.
TrialFigures parameters_as_figures(const Series& series, std::span<const ParameterInfo* const> wanted) {
  TrialFigures figures;
  const Evaluation measured = evaluate(series);
  for (const ParameterInfo* parameter : wanted) {
    const bool between_places =
        parameter->key.starts_with('A') || parameter->key.starts_with('E') || parameter->key.starts_with('M');
    figures.figures.push_back({(measured.parameters.*parameter->member)->in_native(), between_places, false});
  }
  figures.evaluate = [wanted = std::vector(wanted.begin(), wanted.end())](const Series& trial,
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

TEST(TrialModel, DrawsTheSameByMomentsOfCellsAsByReadings) {
  const Series complete = table2::series();
  const Series gaps = testing_support::make_series({0, 10, 20}, {{1, 2, 3}, {1.5, none, 3.5}, {0.5, 2.5, 2.5}},
                                                   {{4, 5, none}, {4.5, 5.5, none}, {3.5, 4.5, none}});
  const ReadingNoise exact{}, white{.reading = 0.3},
      all{.reading = 0.3, .run = 0.2, .target = 0.1, .up_down_correlation = -0.5, .target_direction = 0.1};
  for (const Series* series : {&complete, &gaps})
    for (const ReadingNoise& noise : {exact, white, all})
      expect_same_trials(*series, errors_of_length(), {{.key = "stated"}, {noise}, nullptr});
}

TEST(TrialModel, DrawsTheSameBesideADrift) {
  axiometry::Test test{{}, table2::series(), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(1.7);
  UncertaintyInputs inputs = uncertainty_inputs(test.metadata, test.series).value();
  inputs.inputs.push_back(errors_of_length().inputs.front());
  const TestCourse course = course_of(test);
  std::size_t drifts = 0;
  for (const NoiseModel& noise : noise_models({test.metadata, test.series, course, inputs}).models) {
    if (noise.drift) ++drifts;
    expect_same_trials(test.series, inputs, noise);
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
  expect_same_trials(table2::series(), inputs, {{.key = "stated"}, {ReadingNoise{.reading = 0.2}}, nullptr});
}

}  // namespace
}  // namespace axiometry::iso230_2
