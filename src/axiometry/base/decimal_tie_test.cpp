// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/decimal_tie.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace axiometry {
namespace {

TEST(DecimalTie, FindsTheDecimalBehindADifferenceOfPositions) {
  EXPECT_NE((100.0003 - 100.0) * 1000.0, 0.3);
  EXPECT_EQ(nearest_decimal((100.0003 - 100.0) * 1000.0, 1e-10), 0.3);
  EXPECT_EQ(nearest_decimal(0.1 + 0.2, 1e-15), 0.3);
  EXPECT_EQ(nearest_decimal(-0.0004 * 1000.0, 1e-15), -0.4);
  EXPECT_EQ(nearest_decimal(0.0, 0.0), 0.0);
}

TEST(DecimalTie, LeavesWhatIsNoDecimal) {
  EXPECT_EQ(nearest_decimal(1.0 / 3.0, 1e-13), 1.0 / 3.0);
  EXPECT_EQ(nearest_decimal(std::sqrt(2.0), 1e-12), std::sqrt(2.0));
  EXPECT_EQ(nearest_decimal(0.123456, 0.5), 0.123456);  // an error that would let everything be everything
}

TEST(DecimalTie, FindsEveryDecimalOfAMeasuredPosition) {
  std::mt19937_64 random(14);
  for (const int places : {4, 5, 6, 7}) {  // of mm: 0.1, 0.01, 0.001, 0.0001 µm
    const double unit = std::pow(10.0, places);
    for (int k = 0; k < 20'000; ++k) {
      const auto target = static_cast<double>(static_cast<long>(random() % 20'000) - 5'000) / 10.0;
      const long steps = static_cast<long>(random() % 2'000'000) - 1'000'000;
      const double measured = (std::round(target * unit) + static_cast<double>(steps)) / unit;
      const double error = 16.0 * unit_roundoff * 1000.0 * (std::abs(target) + std::abs(measured));
      EXPECT_EQ(nearest_decimal((measured - target) * 1000.0, error), static_cast<double>(steps) / (unit / 1000.0))
          << measured << " at " << target;
    }
  }
}

TEST(DecimalTie, KeepsAValueAtItsLimit) {
  const DecimalReadings readings{11, 5, 10.0};
  EXPECT_TRUE(at_most(0.1 + 0.2, 0.3, rounding_of_means(readings)));
  EXPECT_TRUE(at_most(0.3, 0.1 + 0.2, 0.0));
  EXPECT_FALSE(at_most(0.3, 0.3 - 1e-12, rounding_of_means(readings)));
  EXPECT_FALSE(at_most(0.3 + 1e-12, 0.3, rounding_of_means(readings)));
  EXPECT_TRUE(at_most(0.3 - 1e-12, 0.3, 0.0));
}

TEST(DecimalTie, StaysFarBelowTheLastPlaceOfUsualReadings) {
  const DecimalReadings usual{11, 5, 1000.0};
  EXPECT_LT(rounding_of_means(usual), 1e-11);
  EXPECT_LT(rounding_of_spreads(usual), 1e-10);
}

}  // namespace
}  // namespace axiometry
