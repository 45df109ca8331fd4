// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/chi_squared.h"

#include <gtest/gtest.h>

namespace axiometry::tracking {
namespace {

// Golden: scipy.stats.chi2.sf.
TEST(ChiSquared, TailsAgreeWithTables) {
  EXPECT_NEAR(chi_squared_tail(3.841458820694124, 1), 0.05, 1e-15);
  EXPECT_NEAR(chi_squared_tail(5.991464547107979, 2), 0.05, 1e-14);
  EXPECT_NEAR(chi_squared_tail(11.344866730144373, 3), 0.01, 1e-14);
  EXPECT_NEAR(chi_squared_tail(100.0, 100), 0.48119168452795674, 1e-12);
  EXPECT_NEAR(chi_squared_tail(1200.0, 1001) / 1.3490075807543988e-05, 1.0, 1e-10);
  EXPECT_NEAR(chi_squared_tail(60.0, 5) / 1.2154569777183007e-11, 1.0, 1e-11);
  EXPECT_EQ(chi_squared_tail(1e6, 2), 0.0);
  EXPECT_EQ(chi_squared_tail(5.0, 0), 1.0);
  EXPECT_EQ(chi_squared_tail(0.0, 4), 1.0);
}

}  // namespace
}  // namespace axiometry::tracking
