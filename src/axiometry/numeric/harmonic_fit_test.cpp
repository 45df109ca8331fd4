// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/harmonic_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// 1, 2, … up to this one.
std::vector<std::size_t> orders(std::size_t up_to) {
  std::vector<std::size_t> result;
  for (std::size_t h = 1; h <= up_to; ++h) result.push_back(h);
  return result;
}

/// Places about one apart, none where another is.
std::vector<double> uneven_places(std::size_t count, std::uint64_t seed) {
  std::vector<double> places(count);
  fill_uniform({seed, 0, 0}, places);
  for (std::size_t k = 0; k < count; ++k) places[k] = static_cast<double>(k) + 0.6 * places[k];
  return places;
}

std::vector<double> noise(std::size_t count, std::uint64_t seed) {
  std::vector<double> values(count);
  fill_normal({seed, 1, 0}, values);
  return values;
}

template <typename Function>
std::vector<double> values_at(const std::vector<double>& places, const Function& function) {
  std::vector<double> values;
  for (double x : places) values.push_back(function(x));
  return values;
}

TEST(HarmonicFit, FindsLineAndHarmonicsExactlyAtUnevenPlaces) {
  const auto x = uneven_places(40, 1);
  const auto y = values_at(x, [&](double p) {
    const double a = two_pi * (p - x.front()) / 7.3;
    return 3.0 - 0.2 * (p - x.front()) + 1.5 * std::sin(a) + 0.4 * std::cos(a) - 0.3 * std::sin(2 * a);
  });
  const auto fit = fit_harmonics({x, y}, 7.3, orders(2));
  ASSERT_TRUE(fit);
  const double expected[] = {3.0, -0.2, 1.5, 0.4, -0.3, 0.0};
  for (std::size_t k = 0; k < std::size(expected); ++k) EXPECT_NEAR(fit->coefficients[k], expected[k], 1e-12) << k;
  EXPECT_LT(fit->sum_of_squares, 1e-24);
  EXPECT_EQ(fit->degrees_of_freedom, 34u);
}

TEST(HarmonicFit, LosesNoDigitsFarFromZero) {
  auto x = uneven_places(40, 2);
  for (double& p : x) p += 1e6;
  const auto y =
      values_at(x, [&](double p) { return 5.0 + 1e-3 * (p - x[0]) + 2.0 * std::sin(two_pi * (p - x[0]) / 9.0); });
  const auto fit = fit_harmonics({x, y}, 9.0, orders(1));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->coefficients[1], 1e-3, 1e-12);
  EXPECT_NEAR(fit->sine(1), 2.0, 1e-10);
}

TEST(HarmonicFit, RefusesTargetsThatCannotShowThePeriod) {
  std::vector<double> x;
  for (int k = 0; k < 20; ++k) x.push_back(5.0 * k);
  const auto y = noise(20, 3);
  EXPECT_FALSE(fit_harmonics({x, y}, 10.0, orders(1)));  // every half period: no sine
  EXPECT_FALSE(fit_harmonics({x, y}, 5.0, orders(1)));   // every period: a constant
  EXPECT_TRUE(fit_harmonics({x, y}, 20.0, orders(1)));
  const std::vector<double> few = {0.0, 1.0, 2.5, 3.0};
  EXPECT_FALSE(fit_harmonics({few, std::span(y).first(4)}, 2.0, orders(1)));  // as many values as coefficients
}

TEST(HarmonicFit, RefinesThePeriodFromANearbyOne) {
  const auto x = uneven_places(60, 4);
  const auto y = values_at(
      x, [](double p) { return 0.01 * p + std::sin(two_pi * p / 9.876) + 0.5 * std::cos(2 * two_pi * p / 9.876); });
  const auto fit = fit_harmonics_and_period({x, y}, 9.5, orders(2));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->period, 9.876, 1e-9);
  EXPECT_TRUE(fit->period_fitted);
}

TEST(HarmonicFit, StatesTheCovarianceThatTrialsShow) {
  // Population figures from 4 000 seeded trials: their standard deviations have a relative error of 1.1 %.
  const auto x = uneven_places(30, 5);
  constexpr std::size_t trials = 4000;
  double squares[7] = {}, stated[7] = {};
  for (std::size_t t = 0; t < trials; ++t) {
    const auto e = noise(30, 1000 + t);
    std::vector<double> y;
    for (std::size_t k = 0; k < x.size(); ++k)
      y.push_back(1.0 + 0.1 * (x[k] - x[0]) + 2.0 * std::sin(two_pi * (x[k] - x[0]) / 8.0) + 0.1 * e[k]);
    const auto fit = fit_harmonics_and_period({x, y}, 8.0, orders(1));
    ASSERT_TRUE(fit);
    const double truth[] = {1.0, 0.1, 2.0, 0.0, 8.0};
    for (std::size_t k = 0; k < 5; ++k) {
      squares[k] += std::pow(fit->coefficients[k] - truth[k], 2) / trials;
      stated[k] += fit->covariance_of(k, k) / trials;
    }
  }
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(std::sqrt(squares[k] / stated[k]), 1.0, 0.06) << k;
}

TEST(Spectrum, HasItsHighestPeakAtThePeriodWhateverTheLine) {
  const auto x = uneven_places(80, 6);
  const auto y = values_at(x, [](double p) { return 40.0 - 3.0 * p + 0.7 * std::sin(two_pi * p / 6.4 + 1.0); });
  const Spectrum s = spectrum({x, y}, {2.0, 40.0});
  EXPECT_NEAR(s.highest.period, 6.4, 1e-6);
  EXPECT_NEAR(s.highest.amplitude, 0.7, 1e-9);
  EXPECT_NEAR(s.highest.reduction, 1.0, 1e-12);
  EXPECT_FALSE(s.at_end);
  EXPECT_NEAR(s.lines.front().period, 40.0, 1e-9);
  EXPECT_NEAR(s.lines.back().period, 2.0, 1e-9);
}

TEST(Spectrum, AgreesWithTheFitAtEveryLine) {
  const auto x = uneven_places(25, 7);
  const auto y = noise(25, 7);
  const Spectrum s = spectrum({x, y}, {2.2, 12.0});
  const auto about_line = [&] {  // a fit of an invisible amplitude leaves the line: by hand
    double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t k = 0; k < 25; ++k) mx += x[k] / 25, my += y[k] / 25;
    for (std::size_t k = 0; k < 25; ++k)
      xx += (x[k] - mx) * (x[k] - mx), xy += (x[k] - mx) * (y[k] - my), yy += (y[k] - my) * (y[k] - my);
    return yy - xy * xy / xx;
  }();
  for (const SpectralLine& line : s.lines) {
    const auto fit = fit_harmonics({x, y}, line.period, orders(1));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(line.amplitude, std::hypot(fit->sine(1), fit->cosine(1)), 1e-10);
    EXPECT_NEAR(line.reduction, 1.0 - fit->sum_of_squares / about_line, 1e-10);
  }
}

/// Validation: sums by transforms against the fit, also where targets every half period show one of sine and cosine.
TEST(Spectrum, OfManyPlacesAgreesWithTheFitAtEveryLine) {
  std::vector<double> even;
  for (int k = 0; k < 400; ++k) even.push_back(100.0 + 2.0 * k);
  for (const auto& x : {uneven_places(400, 7), even}) {
    const auto e = noise(400, 7);
    std::vector<double> y;
    for (std::size_t k = 0; k < 400; ++k) y.push_back(e[k] + 3.0 * std::sin(x[k] / 3.0) - 0.01 * x[k]);
    const Spectrum s = spectrum({x, y}, {4.2, 300.0});
    const double about_line = [&] {
      double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
      for (std::size_t k = 0; k < 400; ++k) mx += x[k] / 400, my += y[k] / 400;
      for (std::size_t k = 0; k < 400; ++k)
        xx += (x[k] - mx) * (x[k] - mx), xy += (x[k] - mx) * (y[k] - my), yy += (y[k] - my) * (y[k] - my);
      return yy - xy * xy / xx;
    }();
    for (std::size_t k = 0; k < s.lines.size(); k += 7) {
      const auto fit = fit_harmonics({x, y}, s.lines[k].period, orders(1));
      ASSERT_TRUE(fit);
      EXPECT_NEAR(s.lines[k].amplitude, std::hypot(fit->sine(1), fit->cosine(1)), 1e-9) << s.lines[k].period;
      EXPECT_NEAR(s.lines[k].reduction, 1.0 - fit->sum_of_squares / about_line, 1e-11) << s.lines[k].period;
    }
    EXPECT_NEAR(s.highest.period, 2 * std::numbers::pi * 3.0, 0.02);
  }
}

TEST(Spectrum, FindsNothingOnAStraightLine) {
  const auto x = uneven_places(30, 8);
  const auto y = values_at(x, [](double p) { return 1e3 + 0.37 * p; });
  EXPECT_EQ(spectrum({x, y}, {2.0, 15.0}).highest.reduction, 0.0);
  const auto many = uneven_places(300, 8);
  const auto on_line = values_at(many, [](double p) { return 1e3 + 0.37 * p; });
  EXPECT_EQ(spectrum({many, on_line}, {2.0, 15.0}).highest.reduction, 0.0);
}

TEST(FalseAlarm, IsAsFrequentAsStatedAmongWhiteNoise) {
  const auto x = uneven_places(40, 9);
  constexpr PeriodBand band{2.0, 19.0};
  constexpr int trials = 1500;
  int below_tenth = 0, below_hundredth = 0;
  for (int t = 0; t < trials; ++t) {
    const auto y = noise(40, 5000 + static_cast<std::uint64_t>(t));
    const double chance = false_alarm_probability({x, y}, band, spectrum({x, y}, band).highest.reduction);
    below_tenth += chance < 0.1;
    below_hundredth += chance < 0.01;
  }
  // An upper bound: never more often than stated (3 standard errors), and not much rarer.
  EXPECT_LT(below_tenth, 0.1 * trials + 3.0 * std::sqrt(0.09 * trials));
  EXPECT_GT(below_tenth, 0.05 * trials);
  EXPECT_LT(below_hundredth, 0.01 * trials + 3.0 * std::sqrt(0.0099 * trials));
  EXPECT_GT(below_hundredth, 0);
}

TEST(FalseAlarm, OfOneHarmonicIsUniformUnderNoise) {
  const auto x = uneven_places(20, 10);
  constexpr int trials = 4000;
  int below[3] = {};
  constexpr double levels[] = {0.5, 0.1, 0.01};
  for (int t = 0; t < trials; ++t) {
    const auto y = noise(20, 20000 + static_cast<std::uint64_t>(t));
    const double chance = fit_harmonics({x, y}, 5.0, orders(2))->chance_of(2);
    for (int k = 0; k < 3; ++k) below[k] += chance < levels[k];
  }
  for (int k = 0; k < 3; ++k) {
    const double sd = std::sqrt(levels[k] * (1 - levels[k]) * trials);
    EXPECT_NEAR(below[k], levels[k] * trials, 4.0 * sd) << levels[k];
  }
}

}  // namespace
}  // namespace axiometry::numeric
