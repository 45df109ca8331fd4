// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/series/chebyshev.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace axiometry::numeric {
namespace {

std::vector<double> values_of(const ChebyshevPoints& points, double (*f)(double)) {
  std::vector<double> values;
  for (double x : points.points()) values.push_back(f(x));
  return values;
}

TEST(ChebyshevPoints, TellPolynomialsOfFewerDegreesThanPoints) {
  const ChebyshevPoints points(-3.0, 5.0, 4);
  const auto cubic = [](double x) { return 2.0 - x + 0.5 * x * x * x; };
  const std::vector<double> values = values_of(points, cubic);
  for (double x : {-3.0, -1.7, 0.0, 1.0, 4.9, 5.0}) EXPECT_NEAR(points.interpolated(values, x), cubic(x), 1e-13);
}

TEST(ChebyshevPoints, KeepTheBoundOfTheirHeader) {
  const auto f = [](double x) { return 1.0 / (1.0 + x * x); };  // poles at ±i: ρ = 1 + √2, M of ρ = 2.2 below 8
  for (std::size_t count : {10u, 20u, 30u}) {
    const ChebyshevPoints points(-1.0, 1.0, count);
    const std::vector<double> values = values_of(points, f);
    const double bound = 4.0 * 8.0 * std::pow(2.2, 1.0 - double(count)) / 1.2;
    for (double x = -1.0; x <= 1.0; x += 0.03) EXPECT_NEAR(points.interpolated(values, x), f(x), bound) << count;
  }
}

TEST(ChebyshevPoints, TakeAnIntervalOfOnePoint) {
  const ChebyshevPoints points(2.0, 2.0, 3);
  EXPECT_EQ(points.interpolated(std::vector<double>{7.0, 7.0, 7.0}, 2.0), 7.0);
}

}  // namespace
}  // namespace axiometry::numeric
