// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/curves/curve_basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "axiometry/volumetric/curves/gauge.h"

namespace axiometry::volumetric {
namespace {

double value_at(const CurveBasis& basis, const std::vector<double>& coefficients, double q) {
  const ActiveFunctions f = basis.at(q);
  double sum = 0.0;
  for (std::size_t k = 0; k < f.count; ++k) sum += f.values[k] * coefficients[f.first + k];
  return sum;
}

TEST(CurveBasis, SplinesAddUpToOneEverywhereAlsoBeyondTheEnds) {
  const CurveBasis basis = CurveBasis::make(CurveKind::spline, -500.0, 100.0, 7).value();
  EXPECT_EQ(basis.functions(), 10u);
  for (const double q : {-510.0, -500.0, -414.3, -414.2857142857143, 0.0, 99.999, 100.0, 103.0}) {
    const ActiveFunctions f = basis.at(q);
    EXPECT_EQ(f.count, 4u);
    EXPECT_LE(f.first + f.count, basis.functions());
    EXPECT_NEAR(std::accumulate(f.values.begin(), f.values.begin() + f.count, 0.0), 1.0, 1e-14) << q;
  }
}

TEST(CurveBasis, IntegratesItsFunctionsExactly) {
  for (const CurveKind kind : {CurveKind::spline, CurveKind::nodes, CurveKind::legendre}) {
    const CurveBasis basis = CurveBasis::make(kind, 0.0, 300.0, 5).value();
    const std::vector<double> means = basis.means(), slopes = basis.slopes();
    constexpr int steps = 30'000;  // the midpoint rule: 1e-9 of a smooth function
    for (std::size_t j = 0; j < basis.functions(); ++j) {
      std::vector<double> coefficients(basis.functions(), 0.0);
      coefficients[j] = 1.0;
      double mean = 0.0, slope = 0.0;
      for (int k = 0; k < steps; ++k) {
        const double q = 300.0 * (k + 0.5) / steps;
        mean += value_at(basis, coefficients, q) / steps;
        slope += value_at(basis, coefficients, q) * (2.0 * q / 300.0 - 1.0) / steps;
      }
      EXPECT_NEAR(means[j], mean, 1e-8);
      EXPECT_NEAR(slopes[j], slope, 1e-8);
    }
  }
}

TEST(CurveBasis, LegendrePolynomialsAreThoseOfTheInterval) {
  const CurveBasis basis = CurveBasis::make(CurveKind::legendre, 0.0, 100.0, 3).value();
  const ActiveFunctions f = basis.at(75.0);  // x = 1/2
  EXPECT_DOUBLE_EQ(f.values[2], -0.125);
  EXPECT_DOUBLE_EQ(f.values[3], -0.4375);
}

TEST(CurveBasis, HoldsTheStraightLine) {
  for (const CurveKind kind : {CurveKind::spline, CurveKind::legendre, CurveKind::nodes})
    for (const std::size_t size : {1u, 4u}) {
      const CurveBasis basis = CurveBasis::make(kind, -100.0, 300.0, size).value();
      for (const double q : {-100.0, -20.0, 130.0, 300.0})
        EXPECT_NEAR(value_at(basis, basis.line(), q), (q - 100.0) / 200.0, 1e-14) << curve_kind_name(kind) << size;
    }
}

TEST(CurveBasis, RefusesTravelsAndSizesThatAreNone) {
  EXPECT_FALSE(CurveBasis::make(CurveKind::spline, 1.0, 1.0, 3));
  EXPECT_FALSE(CurveBasis::make(CurveKind::spline, 0.0, 1.0, 0));
  EXPECT_FALSE(CurveBasis::make(CurveKind::legendre, 0.0, 1.0, 16));
}

TEST(Gauge, LeavesCoefficientsWhoseMeanAndStraightLineAreZero) {
  const CurveBasis basis = CurveBasis::make(CurveKind::spline, 0.0, 600.0, 6).value();
  for (const ErrorMotion error : {ErrorMotion{0, 0}, ErrorMotion{0, 1}, ErrorMotion{2, 4}}) {
    const Gauge gauge(basis, error);
    EXPECT_EQ(gauge.removed(), error.is_straightness() ? 2u : 1u);
    std::vector<double> free(basis.functions());
    for (std::size_t k = 0; k < free.size(); ++k)
      free[k] = k < gauge.removed() ? 0.0 : std::sin(1.0 + 3.0 * static_cast<double>(k));
    gauge.apply_transposed(free.data(), 1);
    for (const auto& constraint : gauge.constraints())
      EXPECT_NEAR(std::inner_product(free.begin(), free.end(), constraint.begin(), 0.0), 0.0, 1e-14);
    std::vector<double> back = free;
    gauge.apply(back.data(), 1);
    EXPECT_NEAR(back[0], 0.0, 1e-14);
  }
}

}  // namespace
}  // namespace axiometry::volumetric
