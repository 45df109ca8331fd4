// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "axiometry/numeric/moments.h"
#include "tests/support/series.h"
#include "tests/support/statistics_of_trials.h"
#include "tests/support/two_samples.h"

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

/// Mean and estimator of every cell that has readings, a row for each: as draw_moments() draws them, and of readings.
struct CellSamples {
  static constexpr std::size_t trials = 16'000;
  std::vector<std::vector<double>> rows;
};

CellSamples samples_by_moments(const Series& series, const ReadingPosterior& posterior,
                               const ReadingPosterior::TakeAway& take_away) {
  const std::size_t cells = 2 * series.target_count(), trials = CellSamples::trials;
  std::vector<double> means(cells * trials), estimators(cells * trials);
  posterior.draw_moments({31, 0, 0}, {{means, trials}, {estimators, trials}}, take_away);
  CellSamples found;
  for (std::size_t c = 0; c < cells; ++c) {
    if (series.count(c % series.target_count(), static_cast<Direction>(c / series.target_count())) == 0) {
      EXPECT_TRUE(std::isnan(means[c * trials])) << c;
      continue;
    }
    for (const auto* of : {&means, &estimators})
      found.rows.emplace_back(of->begin() + std::ptrdiff_t(c * trials), of->begin() + std::ptrdiff_t((c + 1) * trials));
  }
  return found;
}

CellSamples samples_by_readings(const Series& series, const ReadingPosterior& posterior,
                                const ReadingPosterior::TakeAway& take_away) {
  CellSamples found;
  posterior.draw_cells({32, 0, 0}, CellSamples::trials, [&](std::size_t place, numeric::Rows<double> readings) {
    if (take_away) take_away(place, readings);
    std::vector<double> means, estimators, cell;
    for (std::size_t t = 0; t < CellSamples::trials; ++t) {
      cell.clear();
      for (std::size_t j = 0; j < series.run_count(); ++j)
        if (const double x = readings.row(j, CellSamples::trials)[t]; !std::isnan(x)) cell.push_back(x);
      const numeric::Moments moments = numeric::moments(cell);
      means.push_back(moments.mean);
      estimators.push_back(moments.standard_deviation);
    }
    found.rows.push_back(std::move(means));
    found.rows.push_back(std::move(estimators));
  });
  return found;
}

void expect_same_cells(const Series& series, const ReadingNoise& noise,
                       const ReadingPosterior::TakeAway& take_away = {}) {
  const ReadingPosterior posterior(series, noise);
  const CellSamples found = samples_by_moments(series, posterior, take_away),
                    expected = samples_by_readings(series, posterior, take_away);
  ASSERT_EQ(found.rows.size(), expected.rows.size());
  constexpr std::size_t trials = CellSamples::trials;
  std::vector<std::vector<double>> ranks, expected_ranks;
  for (std::size_t k = 0; k < found.rows.size(); ++k) {
    const auto own = testing_support::sample_moments(found.rows[k]),
               other = testing_support::sample_moments(expected.rows[k]);
    EXPECT_LT(testing_support::mean_departure(own, other, trials), testing_support::million_to_one_of_z) << k;
    EXPECT_LT(testing_support::variance_departure(own, other, trials), testing_support::million_to_one_of_z) << k;
    EXPECT_LT(testing_support::two_sample_distance(found.rows[k], expected.rows[k]), testing_support::million_to_one)
        << k;
    ranks.push_back(testing_support::standard_ranks(found.rows[k]));
    expected_ranks.push_back(testing_support::standard_ranks(expected.rows[k]));
  }
  const auto correlation = [&](const auto& of, std::size_t a, std::size_t b) {
    double sum = 0.0;
    for (std::size_t t = 0; t < trials; ++t) sum += of[a][t] * of[b][t] / double(trials);
    return sum;
  };
  const double slack = 5.5 * std::sqrt(2.0 / double(trials));  // of some thousand pairs one passes 5.5 once in 10⁴
  for (std::size_t a = 0; a < ranks.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_NEAR(correlation(ranks, a, b), correlation(expected_ranks, a, b), slack) << a << ", " << b;
}

TEST(ReadingPosterior, DrawsMomentsOfCellsAsOfTheReadingsThatItWouldMake) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  const Series complete = table2::series();
  const Series gaps =
      testing_support::make_series({0, 10, 20, 30},
                                   {{1, 2, 3, 4},
                                    {1.5, none, 3.5, none},
                                    {0.5, 2.5, 2.5, none},
                                    {1.2, 2.2, none, none},
                                    {0.9, none, none, 4.1},
                                    {1.1, 2.1, 3.2, none}},
                                   {{4, 5, none, 7},
                                    {4.5, 5.5, none, 7.2},
                                    {3.5, 4.5, none, none},
                                    {3.9, none, none, none},
                                    {4.1, 5.2, none, none},
                                    {4.4, 5.1, none, none}});  // cells of 6, 4, 4, 2, 6, 5, 0 and 2 readings
  const ReadingNoise white{.reading = 0.3},
      all{.reading = 0.3, .run = 0.2, .target = 0.1, .up_down_correlation = -0.5, .target_direction = 0.1};
  for (const Series* series : {&complete, &gaps})
    for (const ReadingNoise& noise : {white, all}) {
      SCOPED_TRACE(series == &complete ? "complete" : "with gaps");
      expect_same_cells(*series, noise);
    }
}

TEST(ReadingPosterior, DrawsMomentsOfCellsOfThreeAndOfOne) {
  const ReadingNoise white{.reading = 0.5};
  expect_same_cells(testing_support::make_series({0, 10, 20}, {{1, 2, 3}, {1.5, 2.5, 3.5}, {0.2, 2.5, 2.1}},
                                                 {{4, 5, none}, {none, none, none}, {none, none, 5}}),
                    white);
}

TEST(ReadingPosterior, DrawsMomentsOfCellsLessWhatIsTakenAway) {
  const ReadingPosterior::TakeAway slope = [](std::size_t place, numeric::Rows<double> readings) {
    for (std::size_t j = 0; j < readings.values.size() / readings.stride; ++j)
      for (double& x : readings.row(j, readings.stride)) x -= 0.4 * double(j) + 0.1 * double(place);
  };
  expect_same_cells(testing_support::make_series({0, 10, 20}, {{1, 2, 3}, {1.5, none, 3.5}, {0.2, 2.5, 2.1}},
                                                 {{4, 5, 6}, {4.2, 5.2, 6.2}, {4.1, 5.4, 5.9}}),
                    {.reading = 0.3, .run = 0.1}, slope);
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

/// E of the long run of an axis whose temperature changes between the runs: 0.3 °C on 0.5 m.
TEST(ReadingPosterior, HoldsTheLongRunWhereRunsHaveSlopesOfTheirOwn) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::mt19937_64 random(19);
  std::normal_distribution<double> scatter(0.0, 0.2), tilt(0.0, 1.5);
  const std::vector<double> targets{0, 50, 100, 150, 200, 250, 300, 350, 400, 450, 500};
  constexpr std::size_t axes = 200, trials = 400;
  std::size_t held = 0;
  double width = 0.0;
  std::array<double, 3> sd{};  // at the beginning, where the axis stays in its place, in the middle and at the end
  for (std::size_t k = 0; k < axes; ++k) {
    std::vector<testing_support::RunDeviations> up(5), down(5);
    for (std::size_t j = 0; j < 5; ++j) {
      const double own = tilt(random);
      for (const double x : targets) {
        up[j].push_back((own + 6.0) * x / 500.0 + scatter(random));
        down[j].push_back((own + 6.0) * x / 500.0 - 1.0 + scatter(random));
      }
    }
    std::vector<double> means(22 * trials), sds(22 * trials), E(trials);
    const numeric::Rows<double> mean_rows{means, trials}, sd_rows{sds, trials};
    ReadingPosterior(testing_support::make_series(targets, up, down), {}).draw_long_run({k, 0, 0}, mean_rows, sd_rows);
    for (std::size_t t = 0; t < trials; ++t) {
      double least = mean_rows.row(0, trials)[t], largest = least;
      for (std::size_t c = 0; c < 22; ++c) {
        least = std::min(least, mean_rows.row(c, trials)[t]);
        largest = std::max(largest, mean_rows.row(c, trials)[t]);
      }
      E[t] = largest - least;
    }
    std::ranges::sort(E);
    held += E[trials / 40] <= 7.0 && 7.0 <= E[trials - trials / 40];
    width += (E[trials - trials / 40] - E[trials / 40]) / axes;
    for (std::size_t at = 0; at < 3; ++at) sd[at] += numeric::moments(sd_rows.row(5 * at, trials)).mean / axes;
  }
  EXPECT_LT(width, 1.3 * 2.0 * 2.8 * 1.5 / std::sqrt(5.0)) << "k of four degrees of freedom for the mean of five tilts";
  EXPECT_LT(sd[0], 0.7);
  EXPECT_NEAR(sd[1], std::hypot(0.2, 0.75), 0.2);
  EXPECT_NEAR(sd[2], std::hypot(0.2, 1.5), 0.4);
  EXPECT_GT(static_cast<double>(held) / axes, 0.90);  // 95 % less three standard deviations of the binomial
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
