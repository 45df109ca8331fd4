// SPDX-License-Identifier: Apache-2.0
//
// Validation: the published figures of the paper's appendix, and 40 digits from tests/uncertainty_oracle.py.
#include "axiometry/standards/readings/thermal_expansion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/golden_csv.h"

namespace axiometry {
namespace {

using testing::HasSubstr;
using uncertainty::Constant;
using uncertainty::Distribution;
using uncertainty::Normal;
using uncertainty::Triangular;
using uncertainty::Uniform;

Distribution uniform(double lower, double upper) { return Distribution::make(Uniform{lower, upper}).value(); }

TEST(ThermalExpansion, HasTheFactorAndUncertaintyOfThePapersExample) {
  const ThermalState state{11.0, 2.45};
  EXPECT_NEAR(thermal_factor(state), 1.0 / (1.0 + 11e-6 * 2.45), 2.3e-16);
  const double u = thermal_uncertainty(state, {2.2 / std::sqrt(12.0), 1.3 / std::sqrt(12.0)});
  EXPECT_NEAR(u, 4.411319963625311, 1e-9 * u);
}

TEST(ThermalExpansion, HasTheThreePublishedFiguresOfTheAppendix) {
  struct Row {
    Uniform alpha, dT;
    double exact, linear;  // as printed, 1e-6
  };
  for (const Row& row : {Row{{10.53, 12.87}, {-2.5, -1.5}, 3.64, 3.64}, Row{{10.53, 12.87}, {-1, 1}, 6.77, 6.75},
                         Row{{5.85, 17.55}, {-1, 1}, 7.03, 6.75}}) {
    const ThermalState middle{(row.alpha.lower + row.alpha.upper) / 2, (row.dT.lower + row.dT.upper) / 2};
    const double linear = thermal_uncertainty(middle, {(row.alpha.upper - row.alpha.lower) / std::sqrt(12.0),
                                                       (row.dT.upper - row.dT.lower) / std::sqrt(12.0)});
    const auto exact = ThermalFactorDistribution::make(row.alpha, row.dT)->moments();
    EXPECT_NEAR(exact.standard_deviation, row.exact, 0.005);
    EXPECT_NEAR(linear, row.linear, 0.0055);  // 6.7550 is printed as 6.75
  }
}

TEST(ThermalExpansion, MomentsAgreeWithFortyDigits) {
  for (const auto& row : testing_support::golden_rows("uncertainty/thermal.csv")) {
    const auto moments = thermal_moments(uniform(row[0], row[1]), uniform(row[2], row[3]));
    EXPECT_NEAR(moments.standard_deviation, row[5] * 1e6, 1e-13 * row[5] * 1e6) << row[0] << " " << row[2];
    EXPECT_NEAR(moments.mean, row[4] * 1e6, 1e-14 * std::abs(row[4] * 1e6) + 1e-14 * row[5] * 1e6);
  }
}

/// Integral of the density times a power of the departure from `middle`, piece by piece between the breaks of Table
/// A.1, by a midpoint rule on a scale that is fine at both ends (they are logarithmic at α_m near 0).
double integral(const ThermalFactorDistribution& f, std::vector<double> breaks, double middle, int power) {
  double sum = 0.0;
  std::ranges::sort(breaks);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    constexpr int steps = 4000;
    const double width = breaks[k + 1] - breaks[k];
    for (int j = 0; j < steps; ++j) {
      const double t = (j + 0.5) / steps;
      const double place = breaks[k] + width * t * t * (3.0 - 2.0 * t);
      sum += width * 6.0 * t * (1.0 - t) / steps * f.density(place) * std::pow(place - middle, power);
    }
  }
  return sum;
}

TEST(ThermalExpansion, DensityIntegratesToOneAndToTheMomentsInEveryRowOfTheTable) {
  struct Row {
    const char* name;
    Uniform alpha, dT;
  };
  for (const Row& row : {Row{"0 < x_m, wide x", {10, 12}, {1, 4}}, Row{"0 < x_m, wide y", {5, 20}, {2, 3}},
                         Row{"x_m < 0 < x_M", {10, 12}, {-1, 2}}, Row{"x_M < 0, wide x", {10, 12}, {-4, -1}},
                         Row{"x_M < 0, wide y", {5, 20}, {-3, -2}}, Row{"from zero", {10, 12}, {0, 2}},
                         Row{"to zero", {10, 12}, {-2, 0}}, Row{"hardly known", {0.01, 24}, {-30, 80}}}) {
    const auto f = ThermalFactorDistribution::make(row.alpha, row.dT).value();
    std::vector<double> breaks;
    for (double alpha : {row.alpha.lower, row.alpha.upper})
      for (double dT : {row.dT.lower, row.dT.upper}) breaks.push_back(thermal_departure({alpha, dT}));
    const auto moments = f.moments();
    const double sd = moments.standard_deviation;
    EXPECT_NEAR(integral(f, breaks, 0.0, 0), 1.0, 1e-6) << row.name;
    EXPECT_NEAR(integral(f, breaks, moments.mean, 1), 0.0, 1e-6 * sd) << row.name;
    EXPECT_NEAR(integral(f, breaks, moments.mean, 2), sd * sd, 2e-6 * sd * sd) << row.name;
  }
}

TEST(ThermalExpansion, DensityIsThatOfTableA1) {
  // Rows with x_M < 0: the condition for y_M/y_m in the middle is x_m y_m < x_M y_M, not its opposite as printed.
  const auto wide_x = ThermalFactorDistribution::make({10, 12}, {-4, -1}).value();
  const double departure = 25.0;  // between z_MM (12) and z_mm (40)
  const double z = 1.0 + departure * 1e-6;
  EXPECT_NEAR(wide_x.density(departure), std::log(12.0 / 10.0) / (2.0 * 3.0 * z * z), 1e-14);
  const auto wide_y = ThermalFactorDistribution::make({5, 20}, {-3, -2}).value();
  EXPECT_NEAR(wide_y.density(departure), std::log(3.0 / 2.0) / (15.0 * 1.0 * z * z), 1e-14);
  EXPECT_EQ(wide_y.density(-1.0), 0.0);
  EXPECT_EQ(wide_y.density(61.0), 0.0);
}

TEST(ThermalExpansion, KnowsAlphaMattersAtTwentyDegrees) {
  const auto moments = thermal_moments(uniform(5.85, 17.55), uniform(-1, 1));
  const double linear = thermal_uncertainty({11.7, 0.0}, {11.7 / std::sqrt(12.0), 1.0 / std::sqrt(3.0)});
  EXPECT_EQ(linear, thermal_uncertainty({11.7, 0.0}, {0.0, 1.0 / std::sqrt(3.0)}));
  EXPECT_GT(moments.standard_deviation, 1.04 * linear);
}

TEST(ThermalExpansion, MomentsOfOtherDistributionsAreThoseOfTheProduct) {
  const auto same_by_name = thermal_moments(uniform(10, 12), Distribution::make(Triangular{1.0, 4.0}).value());
  const double u_T = 3.0 / std::sqrt(24.0);
  const double u_alpha = 2.0 / std::sqrt(12.0);
  EXPECT_NEAR(same_by_name.standard_deviation, std::hypot(11.0 * u_T, 2.5 * u_alpha, u_T * u_alpha), 1e-3);
  EXPECT_NEAR(same_by_name.mean, -27.5, 2e-3);
  const auto constant = Distribution::make(Constant{11.0}).value();
  EXPECT_EQ(thermal_moments(constant, Distribution::make(Constant{2.0}).value()).standard_deviation, 0.0);
  EXPECT_NEAR(thermal_moments(constant, Distribution::make(Normal{2.0, 0.5}).value()).standard_deviation, 5.5, 1e-3);
}

TEST(ThermalExpansion, RefusesWhatTheTableDoesNotCover) {
  EXPECT_THAT(ThermalFactorDistribution::make({0, 12}, {1, 2}).error().message, HasSubstr("positive limits"));
  EXPECT_THAT(ThermalFactorDistribution::make({12, 10}, {1, 2}).error().message, HasSubstr("positive limits"));
  EXPECT_THAT(ThermalFactorDistribution::make({10, 12}, {2, 1}).error().message, HasSubstr("limits that ascend"));
  EXPECT_THAT(ThermalFactorDistribution::make({10, 12}, {0, 1e5}).error().message, HasSubstr("less than 500000"));
}

}  // namespace
}  // namespace axiometry
