// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/numeric/moments.h"
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using Asked = ReadingPosterior::Asked;
using testing_support::RunDeviations;

constexpr std::size_t trials = 16'000;
constexpr numeric::RandomKey of_draws{1, 0, 0}, of_levels{1, 9, 0};

/// Ten cells whose readings scatter by `scatter` about one value, in runs that are shifted so.
Series shifted_runs(const std::vector<double>& shifts, double scatter) {
  std::vector<RunDeviations> up, down;
  for (std::size_t j = 0; j < shifts.size(); ++j) {
    RunDeviations one, other;
    for (std::size_t i = 0; i < 5; ++i) {
      one.push_back(shifts[j] + scatter * std::sin(7.0 * double(j) + 3.0 * double(i)));
      other.push_back(shifts[j] + scatter * std::sin(5.0 * double(j) + 11.0 * double(i)));
    }
    up.push_back(one);
    down.push_back(other);
  }
  return testing_support::make_series({0, 10, 20, 30, 40}, up, down);
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * double(values.size()))];
}

double sd(const std::vector<double>& values) { return numeric::moments(values).standard_deviation; }

/// Shifts that scatter hides nothing of are normal numbers whose variance nobody knows: Student's t.
TEST(ReadingPosteriorLevels, OfTheLongRunAreThoseOfStudentWhereShiftsAreAllThereIs) {
  for (const auto& [shifts, tolerance] :
       {std::pair{std::vector{-5.0, 1.0, 4.0}, 0.12}, {std::vector{-6.0, 1.0, 4.0, 2.0, -1.0}, 0.06}}) {
    const double n = double(shifts.size());
    const std::vector<double> levels =
        ReadingPosterior(shifted_runs(shifts, 0.05), {}).draw_levels(of_draws, of_levels, trials, Asked::long_run);
    const double expected = numeric::student_t_quantile(0.975, n - 1.0) * sd(shifts) / std::sqrt(n);
    EXPECT_NEAR(quantile(levels, 0.975), expected, tolerance * expected) << n;
    EXPECT_NEAR(quantile(levels, 0.025), -expected, tolerance * expected) << n;
  }
}

/// Runs that lie no farther apart than scatter lets them leave what is known of a mean nearly as it was.
TEST(ReadingPosteriorLevels, OfTheLongRunAreSmallBesideScatterWhereRunsDoNotShift) {
  const std::vector<double> levels = ReadingPosterior(shifted_runs({0, 0, 0, 0, 0}, 1.0), {})
                                         .draw_levels(of_draws, of_levels, trials, Asked::long_run);
  const double of_mean = std::sqrt(0.5 / 5.0);  // scatter of a sine, of five readings
  EXPECT_LT(quantile(levels, 0.975), 0.5 * 1.96 * of_mean);
  EXPECT_GT(quantile(levels, 0.975), 0.0);
}

/// u(d)/√n in the mean of all readings, however much of what is seen of the runs is the machine's.
TEST(ReadingPosteriorLevels, OfReadingsBringTheMeanOfAllToTheMeanOfKnownShifts) {
  for (const double seen : {0.0, 1.0, 4.0}) {
    const Series series = shifted_runs({-seen, 0.0, seen, 0.5 * seen}, 0.3);
    for (const double of_reading : {0.0, 0.15}) {
      const ReadingPosterior posterior(series, {.reading = of_reading, .run = 1.0});
      std::vector<double> readings(2 * 5 * 4 * trials);
      posterior.draw_readings(of_draws, {readings, trials});
      const std::vector<double> levels = posterior.draw_levels(of_draws, of_levels, trials, Asked::readings);
      std::vector<double> means(trials, 0.0);
      for (std::size_t k = 0; k < readings.size(); ++k) means[k % trials] += readings[k] / (2 * 5 * 4);
      for (std::size_t t = 0; t < trials; ++t) means[t] += levels[t];
      EXPECT_NEAR(sd(means), 1.0 / std::sqrt(4.0), 0.02) << seen << ", " << of_reading;
    }
  }
}

TEST(ReadingPosteriorLevels, OfReadingsOfOneRunHaveAllOfItsShift) {
  const std::vector<double> levels = ReadingPosterior(shifted_runs({0.0}, 0.3), {.run = 1.0})
                                         .draw_levels(of_draws, of_levels, trials, Asked::readings);
  EXPECT_NEAR(sd(levels), 1.0, 0.03);
}

TEST(ReadingPosteriorLevels, AreNoneWhereFewerThanThreeCellsTellNoShiftOfSeveralRuns) {
  const Series series = testing_support::make_series({0, 10}, {{-1.0, -0.8}, {0.1, 0.0}, {1.0, 0.9}}, {});
  EXPECT_EQ(ReadingPosterior(series, {.run = 1.0}).draw_levels(of_draws, of_levels, trials, Asked::readings),
            std::vector<double>(trials, 0.0));
}

TEST(ReadingPosteriorLevels, AreNoneOfExactReadings) {
  EXPECT_EQ(ReadingPosterior(shifted_runs({-1.0, 0.0, 1.0}, 0.3), {}, Asked::readings)
                .draw_levels(of_draws, of_levels, trials, Asked::readings),
            std::vector<double>(trials, 0.0));
}

}  // namespace
}  // namespace axiometry::iso230_2
