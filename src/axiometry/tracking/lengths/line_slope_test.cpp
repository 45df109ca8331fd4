// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/line_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "tests/support/series.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::tracking {
namespace {

using axiometry::testing_support::make_series;
using axiometry::testing_support::RunDeviations;

/// Targets every 100 mm measured upwards alone: means in µm, each of so many readings with that s in µm, alike in all
/// targets.
Series targets_measured(const std::vector<double>& means, std::size_t runs, double s) {
  std::vector<double> targets;
  for (std::size_t i = 0; i < means.size(); ++i) targets.push_back(100.0 * static_cast<double>(i));
  double squares = 0.0;
  const auto from_middle = [&](std::size_t run) {
    return static_cast<double>(run) - 0.5 * static_cast<double>(runs - 1);
  };
  for (std::size_t j = 0; j < runs; ++j) squares += from_middle(j) * from_middle(j);
  std::vector<RunDeviations> up(runs), down(runs, RunDeviations(means.size(), std::nan("")));
  for (std::size_t j = 0; j < runs; ++j)
    for (const double mean : means)
      up[j].push_back(mean +
                      (runs > 1 ? s * from_middle(j) / std::sqrt(squares / static_cast<double>(runs - 1)) : 0.0));
  return make_series(targets, up, down);
}

TEST(LineSlope, OfMeansThatScatterAboutTheLineHasTwoDegreesOfFreedomLessThanMeans) {
  const SlopeFit three = fit_slope(targets_measured({0, 3, 0}, 1, 0));
  EXPECT_NEAR(three.slope_um_per_m, 0.0, 1e-12);
  EXPECT_EQ(three.degrees_of_freedom, 1.0);
  EXPECT_NEAR(three.uncertainty_um_per_m, std::sqrt(6.0 / 20000.0) * 1000.0, 1e-9);  // Σr² = 6, Σp² = 20 000 mm²
  EXPECT_EQ(fit_slope(targets_measured({0, 3, 0, 3, 0}, 5, 0.01)).degrees_of_freedom, 3.0);
}

/// Of equal s at each of m targets: (Σp²)² / Σp⁴ times n − 1 degrees of freedom.
TEST(LineSlope, OfRepetitionHasThoseOfWelchAndSatterthwaite) {
  const SlopeFit fit = fit_slope(targets_measured({0, 10, 20}, 5, 2.0));
  EXPECT_NEAR(fit.slope_um_per_m, 100.0, 1e-9);
  EXPECT_NEAR(fit.uncertainty_um_per_m, 1000.0 * 2.0 / std::sqrt(5.0) / std::sqrt(20000.0), 1e-9);
  EXPECT_NEAR(fit.degrees_of_freedom, 2.0 * 4.0, 1e-9);  // both ends count alike, the middle not at all
}

TEST(LineSlope, OfTwoTargetsWithoutRepetitionHasNoUncertainty) {
  EXPECT_EQ(fit_slope(targets_measured({0, 5}, 1, 0)).uncertainty_um_per_m, 0.0);
}

struct Held {
  double percent = 0.0;  ///< how many of a hundred lines hold the scale of the axis
  double mean_U = 0.0;   ///< half width of what they state for 95 %, µm/m
};

/// Of lines over 500 mm with five runs whose scales differ by this (3 µm/m: 0.3 °C of steel), there and back or there
/// alone.
Held held(double between_runs_um_per_m, bool back) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> scatter(0.0, 0.2), scale(0.0, between_runs_um_per_m + 1e-12);
  const std::vector<double> targets{0, 50, 100, 150, 200, 250, 300, 350, 400, 450, 500};
  constexpr int lines = 600;
  constexpr double truth_um_per_m = 12.0;
  Held all;
  for (int line = 0; line < lines; ++line) {
    std::vector<RunDeviations> up(5), down(5, RunDeviations(back ? 0 : targets.size(), std::nan("")));
    for (std::size_t j = 0; j < 5; ++j) {
      const double own = truth_um_per_m + scale(random);
      for (const double x : targets) {
        up[j].push_back(1e-3 * own * x + scatter(random));
        if (back) down[j].push_back(1e-3 * own * x + 0.8 + scatter(random));
      }
    }
    const SlopeFit fit = fit_slope(make_series(targets, up, down));
    const double U = numeric::student_t_quantile(0.975, fit.degrees_of_freedom) * fit.uncertainty_um_per_m;
    all.percent += 100.0 / lines * (std::abs(fit.slope_um_per_m - truth_um_per_m) <= U ? 1.0 : 0.0);
    all.mean_U += U / lines;
  }
  return all;
}

/// 95 % less three standard deviations of the binomial; and no more uncertain than five scales are: 2.8 σ/√5 and some.
TEST(LineSlope, HoldsTheScaleOfTheAxisWhereItChangesBetweenRuns) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  for (const bool back : {true, false})
    for (const double between : {3.0, 1.0, 0.5, 0.0}) {
      const Held lines = held(between, back);
      EXPECT_GT(lines.percent, 92.3) << between << back;
      EXPECT_LT(lines.mean_U, 1.4 * between + 0.5) << between << back;
    }
}

/// No run has a slope of two targets.
TEST(LineSlope, OfTwoTargetsIsOfTheReadings) {
  const SlopeFit fit = fit_slope(targets_measured({0, 10}, 5, 2.0));
  EXPECT_NEAR(fit.slope_um_per_m, 100.0, 1e-9);
  EXPECT_NEAR(fit.degrees_of_freedom, 8.0, 1e-9);
}

}  // namespace
}  // namespace axiometry::tracking
