// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/distributions/chi_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace axiometry::numeric {
namespace {

TEST(ChiSquare, OfTwoDegreesOfFreedomIsAnExponentialDistribution) {
  for (double x : {1e-12, 0.01, 1.0, 3.9, 4.1, 30.0})
    EXPECT_NEAR(chi_square_probability(x, 2.0), -std::expm1(-x / 2), 1e-12 * -std::expm1(-x / 2)) << x;
}

TEST(ChiSquare, OfOneDegreeOfFreedomIsTheSquareOfANormalNumber) {
  for (double z : {0.01, 0.5, 1.0, 1.9599639845400545, 4.0})
    EXPECT_NEAR(chi_square_probability(z * z, 1.0), std::erf(z / std::sqrt(2.0)), 1e-13) << z;
}

TEST(ChiSquare, HoldsItsQuantiles) {
  EXPECT_NEAR(chi_square_quantile(0.95, 10.0), 18.307038053275146, 1e-10);  // tables
  EXPECT_NEAR(chi_square_quantile(0.01, 80.0), 53.540077226, 1e-7);         // tables
  for (double nu : {0.7, 1.0, 4.0, 80.0, 900.0})
    for (double p : {1e-12, 1e-4, 0.5, 0.999})
      EXPECT_NEAR(chi_square_probability(chi_square_quantile(p, nu), nu), p, 1e-10 * p) << nu << " " << p;
}

// Golden: scipy.stats.chi2.sf.
TEST(ChiSquare, TailsAgreeWithTables) {
  EXPECT_NEAR(chi_square_tail(3.841458820694124, 1), 0.05, 1e-15);
  EXPECT_NEAR(chi_square_tail(5.991464547107979, 2), 0.05, 1e-14);
  EXPECT_NEAR(chi_square_tail(11.344866730144373, 3), 0.01, 1e-14);
  EXPECT_NEAR(chi_square_tail(100.0, 100), 0.48119168452795674, 1e-12);
  EXPECT_NEAR(chi_square_tail(1200.0, 1001) / 1.3490075807543988e-05, 1.0, 1e-10);
  EXPECT_NEAR(chi_square_tail(60.0, 5) / 1.2154569777183007e-11, 1.0, 1e-11);
  EXPECT_EQ(chi_square_tail(1e6, 2), 0.0);
  EXPECT_EQ(chi_square_tail(std::numeric_limits<double>::infinity(), 3), 0.0);
  EXPECT_EQ(chi_square_tail(5.0, 0), 1.0);
  EXPECT_EQ(chi_square_tail(0.0, 4), 1.0);
}

}  // namespace
}  // namespace axiometry::numeric
