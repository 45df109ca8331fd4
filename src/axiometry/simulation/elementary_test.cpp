// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace axiometry::simulation {
namespace {

TEST(Elementary, WaveIsSineAndCosineOfWholeTurns) {
  for (int k = -4000; k <= 4000; ++k) {
    const double turns = static_cast<double>(k) / 1024.0;  // exact, so that only the function errs
    const long double angle = 2.0L * std::numbers::pi_v<long double> * static_cast<long double>(turns);
    EXPECT_NEAR(wave(turns).sine, static_cast<double>(std::sin(angle)), 4e-16) << turns;
    EXPECT_NEAR(wave(turns).cosine, static_cast<double>(std::cos(angle)), 4e-16) << turns;
  }
}

TEST(Elementary, QuarterTurnsAreExact) {
  EXPECT_EQ(wave(0.25).sine, 1.0);
  EXPECT_EQ(wave(0.25).cosine, 0.0);
  EXPECT_EQ(wave(-0.25).sine, -1.0);
  EXPECT_EQ(wave(0.5).cosine, -1.0);
  EXPECT_EQ(wave(0.5).sine, 0.0);
  EXPECT_EQ(wave(1e9).sine, 0.0);
}

TEST(Elementary, ExponentialIsWithinItsBound) {
  for (int k = -5600; k <= 5600; ++k) {
    const double x = static_cast<double>(k) / 8.0;
    const double exact = static_cast<double>(std::exp(static_cast<long double>(x)));
    EXPECT_NEAR(exponential(x) / exact, 1.0, 4e-16) << x;
  }
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-701.0), 0.0);
  EXPECT_EQ(exponential(-1e300), 0.0);
}

}  // namespace
}  // namespace axiometry::simulation
