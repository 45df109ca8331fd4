// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/numeric/moments.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::none;

namespace table2 = testing_support::table2;

struct Draws {
  std::vector<double> values;
  numeric::Rows<double> rows() { return {values, trials}; }
  static constexpr std::size_t trials = 4000;
};

Draws readings_of(const Series& series, const ReadingNoise& noise) {
  Draws draws{std::vector<double>(2 * series.target_count() * series.run_count() * Draws::trials)};
  ReadingPosterior(series, noise).draw_readings({1, 0, 0}, draws.rows());
  return draws;
}

TEST(ReadingPosterior, WithoutNoiseIsWhatWasRead) {
  const Series series = table2::series();
  Draws draws = readings_of(series, {});
  for (std::size_t i = 0; i < series.target_count(); ++i)
    for (std::size_t j = 0; j < series.run_count(); ++j)
      EXPECT_EQ(draws.rows().row(i * series.run_count() + j, Draws::trials)[17], series.cell(i, Direction::up)[j]);
}

TEST(ReadingPosterior, TakesNoiseOutOfTheScatterInsteadOfAddingIt) {
  const Series series = table2::series();
  Draws draws = readings_of(series, {.reading = 0.2});
  double observed = 0.0, true_variance = 0.0;
  std::vector<double> cell(5);
  for (std::size_t c = 0; c < 22; ++c) {
    observed += std::pow(numeric::moments(series.cell(c % 11, static_cast<Direction>(c / 11))).standard_deviation, 2);
    for (std::size_t t = 0; t < Draws::trials; ++t) {
      for (std::size_t j = 0; j < 5; ++j) cell[j] = draws.rows().row(c * 5 + j, Draws::trials)[t];
      true_variance += std::pow(numeric::moments(cell).standard_deviation, 2) / double(Draws::trials);
    }
  }
  EXPECT_LT(true_variance, observed - 22 * 0.2 * 0.2 * 0.5);
  EXPECT_GT(true_variance, observed - 22 * 0.2 * 0.2 * 1.5);
}

TEST(ReadingPosterior, LeavesMissingReadingsMissing) {
  const Series series = testing_support::make_series({0, 10, 20}, {{1, 2, 3}, {1.5, none, 3.5}, {0.5, 2.5, 2.5}},
                                                     {{4, 5, none}, {4.5, 5.5, none}, {3.5, 4.5, none}});
  Draws draws = readings_of(series, {.reading = 0.3, .run = 0.1, .target = 0.1, .target_direction = 0.1});
  EXPECT_TRUE(std::isnan(draws.rows().row(1 * 3 + 1, Draws::trials)[0]));
  EXPECT_TRUE(std::isnan(draws.rows().row((3 + 2) * 3, Draws::trials)[0]));
  EXPECT_TRUE(std::isfinite(draws.rows().row((3 + 1) * 3, Draws::trials)[0]));
  EXPECT_TRUE(std::isfinite(draws.rows().row(1 * 3 + 2, Draws::trials)[0]));
}

/// Numbers for what either direction has of its own are left out where it has nothing, and those behind them stay.
TEST(ReadingPosterior, DrawsTheSameWhereDirectionsHaveNextToNothingOfTheirOwn) {
  const Series series = table2::series();
  for (std::size_t trials : {80u, 100u}) {
    std::vector<double> without(2 * 11 * 5 * trials), with(without.size());
    ReadingPosterior(series, {.reading = 0.3, .run = 0.2}).draw_readings({1, 0, 7}, {without, trials});
    ReadingPosterior(series, {.reading = 0.3, .run = 0.2, .target_direction = 1e-160})
        .draw_readings({1, 0, 7}, {with, trials});
    ASSERT_NE(without[0], without[1]);
    EXPECT_EQ(without, with) << trials;
  }
}

TEST(ReadingPosterior, GivesASingleApproachTheUncertaintyOfItsNoise) {
  const Series series = testing_support::make_series({0, 50}, {{0, 100}}, {});
  Draws draws = readings_of(series, {.reading = 0.5});
  EXPECT_NEAR(numeric::moments(draws.rows().row(1, Draws::trials)).standard_deviation, 0.5, 0.03);
}

TEST(ReadingPosterior, StaysFiniteWhereATargetsErrorIsAllThereIs) {
  const Series series = testing_support::make_series({0, 50, 100}, {{0, 1, 3}}, {{1, 2, 4}});
  for (double correlation : {1.0, -1.0, 0.0}) {
    Draws draws = readings_of(series, {.target = 0.3, .up_down_correlation = correlation});
    for (double x : draws.values) ASSERT_TRUE(std::isfinite(x));
  }
}

TEST(ReadingPosterior, SharesAShiftOfARunBetweenMachineAndMeasurement) {
  std::vector<testing_support::RunDeviations> up, down;
  for (double shift : {-4.0, -2.0, 0.0, 2.0, 4.0}) {  // far more than the readings scatter otherwise
    const double wiggle = 0.01 * shift * shift;
    up.push_back({shift + wiggle, 1 + shift, 2 + shift, 3 + shift - wiggle});
    down.push_back({5 + shift, 6 + shift - wiggle, 7 + shift + wiggle, 8 + shift});
  }
  const Series series = testing_support::make_series({0, 10, 20, 30}, up, down);
  const auto scatter = [&](double run_noise) {
    Draws draws = readings_of(series, {.run = run_noise});
    std::vector<double> cell(5);
    double sum = 0.0;
    for (std::size_t t = 0; t < Draws::trials; ++t) {
      for (std::size_t j = 0; j < 5; ++j) cell[j] = draws.rows().row(5 + j, Draws::trials)[t];
      sum += numeric::moments(cell).standard_deviation / double(Draws::trials);
    }
    return sum;
  };
  EXPECT_NEAR(scatter(0.01), 3.16, 0.05);  // all of it the machine's: √10
  EXPECT_LT(scatter(3.0), 2.5);            // most of it may be the measurement's
}

TEST(ReadingPosterior, DoesNotTakeAMissingRunForAnErrorOfItsTarget) {
  std::vector<testing_support::RunDeviations> up;
  for (double shift : {0.0, 0.0, 8.0}) {  // one run is far off, and one target lacks it
    const double wiggle = 0.1 * (up.size() == 1 ? 1 : -1);
    up.push_back({shift + wiggle, shift - wiggle, shift == 0.0 ? wiggle : none, shift, shift + wiggle});
  }
  const Series series = testing_support::make_series({0, 10, 20, 30, 40}, up, {});
  std::vector<double> means(10 * Draws::trials), sds(10 * Draws::trials);
  const numeric::Rows<double> mean_rows{means, Draws::trials}, sd_rows{sds, Draws::trials};
  ReadingPosterior(series, {.reading = 0.05}).draw_long_run({1, 0, 0}, mean_rows, sd_rows);
  const double with = numeric::moments(mean_rows.row(1, Draws::trials)).mean;
  const double without = numeric::moments(mean_rows.row(2, Draws::trials)).mean;
  EXPECT_NEAR(with, without, 0.3);  // as measured they differ by 8/3
}

TEST(ReadingPosterior, TakesNoiseOutOfWhatTheReadingsOfARunHaveInCommon) {
  // Four targets share the noise of four readings in the mean of a run: no shift of the machine is left where
  // all that is seen is smaller than the noise.
  std::vector<testing_support::RunDeviations> up;
  for (double shift : {-0.4, 0.3, 0.0, -0.2, 0.3}) up.push_back({shift, shift + 0.1, shift - 0.1, shift});
  const Series series = testing_support::make_series({0, 10, 20, 30}, up, {});
  Draws draws = readings_of(series, {.reading = 1.0});
  double sum = 0.0;
  std::vector<double> cell(5);
  for (std::size_t t = 0; t < Draws::trials; ++t) {
    for (std::size_t j = 0; j < 5; ++j) cell[j] = draws.rows().row(5 + j, Draws::trials)[t];
    sum += numeric::moments(cell).standard_deviation / double(Draws::trials);
  }
  EXPECT_LT(sum, 0.25);  // 0.31 in the readings
}

TEST(ReadingPosterior, CountsADriftAsNoiseOfTheReadingsWhereItCannotBeTold) {
  const Series series = testing_support::make_series({0, 50}, {{0, 1}, {1, 0.2}, {-1, 2}, {0.5, 1.5}}, {});
  Draws with_drift = readings_of(series, {.run = 0.8});
  Draws with_noise = readings_of(series, {.reading = 0.8});
  EXPECT_EQ(with_drift.rows().row(1, Draws::trials)[5], with_noise.rows().row(1, Draws::trials)[5]);
}

TEST(ReadingPosterior, DrawsTheLongRunAboutWhatWasMeasured) {
  const Series series = table2::series();
  std::vector<double> means(22 * Draws::trials), sds(22 * Draws::trials);
  const numeric::Rows<double> mean_rows{means, Draws::trials}, sd_rows{sds, Draws::trials};
  ReadingPosterior(series, {}).draw_long_run({1, 0, 0}, mean_rows, sd_rows);
  for (std::size_t i = 0; i < 11; ++i) {
    const auto measured = numeric::moments(series.cell(i, Direction::down));
    // Shifts common to all readings are not followed, so compare with the first target.
    const auto reference = numeric::moments(series.cell(0, Direction::down));
    std::vector<double> difference(Draws::trials);
    for (std::size_t t = 0; t < Draws::trials; ++t)
      difference[t] = mean_rows.row(11 + i, Draws::trials)[t] - mean_rows.row(11, Draws::trials)[t];
    EXPECT_NEAR(numeric::moments(difference).mean, measured.mean - reference.mean, 0.15);
    EXPECT_GT(numeric::moments(sd_rows.row(11 + i, Draws::trials)).mean, 0.2);
  }
}

/// Nothing but the error of a target: where readings do not scatter, and where there is one alone.
TEST(ReadingPosterior, KnowsNoScatterBesideErrorsOfTargets) {
  const std::vector<double> targets = {0, 10, 20, 30, 40};
  const std::vector<double> run = {1, 2, 2, 3, 1};
  for (std::size_t count : {1, 3}) {
    const std::vector<std::vector<double>> runs(count, run);
    const Series series = testing_support::make_series(targets, runs, runs);
    const ReadingPosterior posterior(series, {.target = 0.3});
    constexpr std::size_t trials = 64;
    std::vector<double> readings(2 * targets.size() * runs.size() * trials);
    posterior.draw_readings({1, 0, 0}, {readings, trials});
    double squares = 0.0;
    for (double x : readings) {
      ASSERT_TRUE(std::isfinite(x));
      squares += x * x;
    }
    EXPECT_NEAR(squares / double(readings.size()), 19.0 / 5.0, 1.0);
  }
}

}  // namespace
}  // namespace axiometry::iso230_2
