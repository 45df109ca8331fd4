// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/sine_beside_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace axiometry::numeric {
namespace {

/// About evenly spaced places, each moved by a part of the period that follows no pattern (golden section).
std::vector<double> shifted_places(std::size_t count, double step, double period) {
  std::vector<double> places;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = std::fmod(static_cast<double>(k) * std::numbers::phi, 1.0);
    places.push_back(step * static_cast<double>(k) + period * share);
  }
  return places;
}

std::vector<double> bent_values(const std::vector<double>& places, double amplitude, double noise) {
  std::vector<double> values;
  std::uint32_t state = 12'345;
  for (const double x : places) {
    state = state * 1'664'525u + 1'013'904'223u;
    const double random = static_cast<double>(state >> 8) / 16'777'216.0 - 0.5;
    const double u = x / places.back();
    values.push_back(7.0 - 30.0 * u + 45.0 * u * u - 20.0 * u * u * u +
                     amplitude * std::sin(2.0 * std::numbers::pi * x / 10.0 + 0.6) + noise * random);
  }
  return values;
}

TEST(SineBesideCurve, IsFoundBesideABentAxis) {
  const std::vector<double> places = shifted_places(21, 50.0, 10.0);
  const auto fit = fit_sine_beside_curve({places, bent_values(places, 1.5, 0.0)}, 10.0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->amplitude, 1.5, 1e-9);
  EXPECT_EQ(fit->degree, 3u);
  EXPECT_LT(fit->chance, 1e-9);
  for (const double x : {3.0, 417.7, 1003.1})
    EXPECT_NEAR(fit->at(x), 1.5 * std::sin(2.0 * std::numbers::pi * x / 10.0 + 0.6), 1e-8);
}

TEST(SineBesideCurve, NoiseAloneIsNotTakenForOne) {
  const std::vector<double> places = shifted_places(21, 50.0, 10.0);
  const auto fit = fit_sine_beside_curve({places, bent_values(places, 0.0, 1.0)}, 10.0);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->chance, 0.01);
  EXPECT_GT(fit->amplitude_u, 0.02);
}

TEST(SineBesideCurve, UncertaintyCoversTheTruth) {
  const std::vector<double> places = shifted_places(41, 25.0, 10.0);
  const auto fit = fit_sine_beside_curve({places, bent_values(places, 1.5, 1.0)}, 10.0);
  ASSERT_TRUE(fit);
  EXPECT_LT(std::abs(fit->amplitude - 1.5), 3.0 * fit->amplitude_u);
  // Uniform noise of a width of 1 has a standard deviation of 0.289; an amplitude √(2/n) of it.
  EXPECT_NEAR(fit->amplitude_u, 0.289 * std::sqrt(2.0 / 41.0), 0.02);
}

TEST(SineBesideCurve, PlacesAtWholeAndHalfPeriodsTellNone) {
  for (const double step : {5.0, 10.0, 50.0}) {
    std::vector<double> places;
    for (int k = 0; k < 30; ++k) places.push_back(step * k);
    EXPECT_FALSE(fit_sine_beside_curve({places, bent_values(places, 1.5, 0.0)}, 10.0)) << step;
  }
}

TEST(SineBesideCurve, AStretchOfFewPeriodsOrPlacesTellsNone) {
  const std::vector<double> few = shifted_places(7, 50.0, 10.0), brief = shifted_places(12, 0.5, 1.0);
  EXPECT_FALSE(fit_sine_beside_curve({few, bent_values(few, 1.5, 0.0)}, 10.0));
  EXPECT_FALSE(fit_sine_beside_curve({brief, bent_values(brief, 1.5, 0.0)}, 10.0));
}

}  // namespace
}  // namespace axiometry::numeric
