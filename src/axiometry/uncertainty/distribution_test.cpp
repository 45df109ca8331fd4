// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::uncertainty {
namespace {

Distribution parsed(std::string_view text) {
  auto distribution = Distribution::parse(text);
  EXPECT_TRUE(distribution) << distribution.error().to_string();
  return distribution ? *distribution : Distribution::make(Constant{}).value();
}

std::string error_of(std::string_view text) {
  const auto distribution = Distribution::parse(text);
  return distribution ? "no error" : distribution.error().message;
}

std::vector<double> drawn(const Distribution& distribution, std::size_t count, numeric::RandomKey key = {7, 3, 1}) {
  std::vector<double> draws(count);
  distribution.sample(key, draws);
  return draws;
}

constexpr std::string_view every_form[] = {
    "constant 3",         "normal 2 0.5",       "t 4 1 2",         "t 0.7 0 1",
    "t 1e+06 0 1",        "uniform -1 3",       "triangular -1 3", "arcsine -1 3",
    "ctrap -1 3 0.5",     "ctrap -1 3 0",       "ctrap -1 3 2",    "trapezoidal -1 3 0.25",
    "trapezoidal -1 3 0", "trapezoidal -1 3 1", "uniform 2 2",     "empirical 1 2 2 7.5"};

TEST(Distribution, RefusesLimitsThatAreSwapped) {
  for (const std::string name : {"uniform", "triangular", "arcsine"})
    EXPECT_EQ(error_of(name + " 3 -3"), "found limits 3 and -3, expected the lower one first");
  EXPECT_EQ(error_of("trapezoidal 3 -3 0.5"), "found limits 3 and -3, expected the lower one first");
  EXPECT_EQ(error_of("ctrap 3 -3 0.5"), "found limits 3 and -3, expected the lower one first");
}

TEST(Distribution, RefusesParametersThatMakeNoSense) {
  EXPECT_EQ(error_of("normal 0 -1"), "found the standard deviation -1, expected one not below 0");
  EXPECT_EQ(error_of("t 0 0 1"), "found 0 degrees of freedom, expected more than 0");
  EXPECT_EQ(error_of("t 0.01 0 1"), "found 0.01 degrees of freedom, expected at least 0.1");
  EXPECT_EQ(error_of("t 3 0 -1"), "found the scale -1, expected one not below 0");
  EXPECT_EQ(error_of("trapezoidal 0 1 1.5"), "found the ratio 1.5 of top to base, expected 0 to 1");
  EXPECT_EQ(error_of("ctrap -1 1 1.5"),
            "found limits -1 and 1 known within ±1.5, expected at most ±1, half their distance");
  EXPECT_EQ(error_of("uniform -1e308 1e308"), "found limits -1e+308 and 1e+308, expected a width below 1e308");
  EXPECT_EQ(Distribution::make(Normal{NAN, 1}).error().message, "found the number nan, expected a finite one");
  EXPECT_EQ(Distribution::make(Empirical{}).error().message,
            "found no value of an empirical distribution, expected at least one");
}

TEST(Distribution, NamesTheWordItDoesNotUnderstand) {
  EXPECT_EQ(error_of("unifrom 0 1"), "found the distribution \"unifrom\", expected perhaps 'uniform'");
  EXPECT_EQ(error_of("blue 0 1"),
            "found the distribution \"blue\", expected constant, normal, t, uniform, triangular, trapezoidal, "
            "arcsine, ctrap, empirical");
  EXPECT_EQ(error_of("normal 0"), "found 1 number after 'normal', expected MEAN SD");
  EXPECT_EQ(error_of("t 3 0 1 2"), "found 4 numbers after 't', expected DEGREES-OF-FREEDOM LOCATION SCALE");
  EXPECT_EQ(error_of("empirical"), "found 0 numbers after 'empirical', expected VALUE…");
  EXPECT_EQ(error_of("normal 0 1,5"), "found \"1,5\" after 'normal', expected a number");
  EXPECT_EQ(error_of(" "), "found nothing, expected a distribution such as 'uniform -0.5 0.5'");
}

TEST(Distribution, ReadsWhatItWrites) {
  for (const std::string_view text : every_form) EXPECT_EQ(parsed(text).text(), text);
}

TEST(Distribution, KnowsItsMoments) {
  // 6.4 of JCGM 101:2008.
  EXPECT_DOUBLE_EQ(*parsed("uniform -1 3").standard_deviation(), 4 / std::sqrt(12));
  EXPECT_DOUBLE_EQ(*parsed("triangular -1 3").standard_deviation(), 2 / std::sqrt(6));
  EXPECT_DOUBLE_EQ(*parsed("arcsine -1 3").standard_deviation(), 2 / std::sqrt(2));
  EXPECT_DOUBLE_EQ(*parsed("trapezoidal -1 3 1").standard_deviation(), 4 / std::sqrt(12));
  EXPECT_DOUBLE_EQ(*parsed("ctrap -1 3 0.5").standard_deviation(), std::sqrt(16 / 12. + 0.25 / 9));
  EXPECT_DOUBLE_EQ(*parsed("t 4 1 2").standard_deviation(), 2 * std::sqrt(2));
  EXPECT_EQ(parsed("t 2 1 2").standard_deviation(), std::nullopt);
  EXPECT_EQ(parsed("t 4 1 2").degrees_of_freedom(), 4.0);
  EXPECT_EQ(parsed("normal 1 2").degrees_of_freedom(), std::nullopt);
  EXPECT_DOUBLE_EQ(parsed("empirical 1 2 2 7").mean(), 3.0);
  EXPECT_DOUBLE_EQ(*parsed("empirical 1 2 2 7").standard_deviation(), std::sqrt(22 / 4.));
}

TEST(Distribution, CentresWithoutChangingItsShape) {
  for (const std::string_view text : every_form) {
    const Distribution original = parsed(text), centred = original.centred();
    EXPECT_NEAR(centred.mean(), 0.0, 1e-15) << text;
    for (const double p : {0.01, 0.3, 0.5, 0.9})
      EXPECT_NEAR(centred.quantile(p) + original.mean(), original.quantile(p),
                  1e-9 * (1 + std::abs(original.quantile(p))))
          << text;
  }
}

TEST(Distribution, DrawsWhatItsDistributionFunctionSays) {
  // Kolmogorov's distance of 40 000 draws exceeds 1.95/√n once in a thousand keys; these keys are fixed.
  constexpr std::size_t n = 40'000;
  for (const std::string_view text : every_form) {
    const Distribution distribution = parsed(text);
    std::vector<double> draws = drawn(distribution, n);
    std::ranges::sort(draws);
    for (double p = 0.005; p < 1.0; p += 0.005) {
      const double x = distribution.quantile(p);
      const double slack = 1e-12 * (1 + std::abs(x));
      const auto below = std::ranges::lower_bound(draws, x - slack) - draws.begin();
      const auto up_to = std::ranges::upper_bound(draws, x + slack) - draws.begin();
      const double margin = 1.95 / std::sqrt(n);
      EXPECT_LE(static_cast<double>(below) / n, p + margin) << text << " at " << p;
      EXPECT_GE(static_cast<double>(up_to) / n, p - margin) << text << " at " << p;
    }
  }
}

TEST(Distribution, DrawsTheQuantilesOfUniformNumbersToTheLastBit) {
  std::vector<double> numbers(10'000);
  numeric::fill_uniform({7, 3, 1}, numbers);
  for (const std::string_view text : {"uniform -1.7 0.3", "uniform 0 1e-9", "triangular -1 2"}) {
    const std::vector<double> draws = drawn(parsed(text), numbers.size());
    for (std::size_t i = 0; i < draws.size(); ++i) ASSERT_EQ(draws[i], parsed(text).quantile(numbers[i])) << text;
  }
}

TEST(Distribution, HasTheTailsOfStudentsDistribution) {
  // Of 200 000 draws about 200 lie beyond the quantile of 1e-3; the standard deviation is 14.
  for (const std::string_view text : {"t 0.5 0 1", "t 1 0 1", "t 2.5 0 1", "t 30 0 1"}) {
    const Distribution t = parsed(text);
    const double far = t.quantile(0.999);
    const auto beyond = std::ranges::count_if(drawn(t, 200'000), [far](double x) { return x > far; });
    EXPECT_NEAR(static_cast<double>(beyond), 200.0, 60.0) << text;
  }
}

TEST(Distribution, GivesTheBeginningOfALongerSampleToAShorterOne) {
  for (const std::string_view text : every_form) {
    const std::vector<double> longer = drawn(parsed(text), 101), shorter = drawn(parsed(text), 37);
    EXPECT_TRUE(std::ranges::equal(shorter, std::span(longer).first(37))) << text;
  }
}

TEST(Distribution, KeepsTheDigitsOfBothTailsOnTheWayFromANormalDraw) {
  for (const std::string_view text : every_form) {
    const Distribution distribution = parsed(text);
    for (const double z : {-3.0, -0.4, 0.0, 0.4, 3.0})
      EXPECT_NEAR(distribution.from_normal(z), distribution.quantile(numeric::normal_probability(z)), 1e-6) << text;
    EXPECT_TRUE(std::isfinite(distribution.from_normal(9.0))) << text;
  }
  const Distribution t = parsed("t 4 0 1");
  EXPECT_DOUBLE_EQ(t.from_normal(9.5), -t.from_normal(-9.5));
  EXPECT_LE(parsed("ctrap -1 3 0.5").from_normal(9.5), 3.5);
}

}  // namespace
}  // namespace axiometry::uncertainty
