// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/series/period_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "axiometry/numeric/harmonic_fit.h"
#include "axiometry/numeric/uneven_values_test_support.h"

namespace axiometry::numeric {
namespace {

TEST(Spectrum, HasItsHighestPeakAtThePeriodWhateverTheLine) {
  const auto x = uneven_places(80, 6);
  const auto y =
      values_at(x, [](double p) { return 40.0 - 3.0 * p + 0.7 * std::sin(2.0 * std::numbers::pi * p / 6.4 + 1.0); });
  const Spectrum s = PeriodSearch(x, {2.0, 40.0}).spectrum(y);
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
  const Spectrum s = PeriodSearch(x, {2.2, 12.0}).spectrum(y);
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
    const Spectrum s = PeriodSearch(x, {4.2, 300.0}).spectrum(y);
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

/// Validation: the fit, at lines before and after the last whose sums are kept, the second time as the first.
TEST(Spectrum, OfMoreLinesThanAreKeptAgreesWithTheFit) {
  const auto x = uneven_places(256, 11);
  const auto y = noise(256, 11);
  const PeriodSearch search(x, {0.00235, 100.0});
  const Spectrum first = search.spectrum(std::vector<double>(y.rbegin(), y.rend())), s = search.spectrum(y);
  constexpr std::size_t kept = 1 << 20;
  ASSERT_GT(s.lines.size(), kept + 20'000);
  EXPECT_EQ(first.lines.size(), s.lines.size());
  for (std::size_t k : {kept - 1, kept, kept + 1, kept + 9'000, s.lines.size() - 1}) {
    const auto fit = fit_harmonics({x, y}, s.lines[k].period, orders(1));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(s.lines[k].amplitude, std::hypot(fit->sine(1), fit->cosine(1)), 1e-9) << k;
  }
}

TEST(Spectrum, FindsNothingOnAStraightLine) {
  const auto x = uneven_places(30, 8);
  const auto y = values_at(x, [](double p) { return 1e3 + 0.37 * p; });
  EXPECT_EQ(PeriodSearch(x, {2.0, 15.0}).spectrum(y).highest.reduction, 0.0);
  const auto many = uneven_places(300, 8);
  const auto on_line = values_at(many, [](double p) { return 1e3 + 0.37 * p; });
  EXPECT_EQ(PeriodSearch(many, {2.0, 15.0}).spectrum(on_line).highest.reduction, 0.0);
}

TEST(FalseAlarm, IsAsFrequentAsStatedAmongWhiteNoise) {
  const auto x = uneven_places(40, 9);
  const PeriodSearch search(x, {2.0, 19.0});
  constexpr int trials = 1500;
  int below_tenth = 0, below_hundredth = 0;
  for (int t = 0; t < trials; ++t) {
    const auto y = noise(40, 5000 + static_cast<std::uint64_t>(t));
    const double chance = search.false_alarm_probability(search.spectrum(y).highest.reduction);
    below_tenth += chance < 0.1;
    below_hundredth += chance < 0.01;
  }
  // An upper bound: never more often than stated (3 standard errors), and not much rarer.
  EXPECT_LT(below_tenth, 0.1 * trials + 3.0 * std::sqrt(0.09 * trials));
  EXPECT_GT(below_tenth, 0.05 * trials);
  EXPECT_LT(below_hundredth, 0.01 * trials + 3.0 * std::sqrt(0.0099 * trials));
  EXPECT_GT(below_hundredth, 0);
}

}  // namespace
}  // namespace axiometry::numeric
