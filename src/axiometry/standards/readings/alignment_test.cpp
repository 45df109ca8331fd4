// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/golden_csv.h"

namespace axiometry {
namespace {

using uncertainty::Arcsine;
using uncertainty::Constant;
using uncertainty::Distribution;
using uncertainty::Normal;
using uncertainty::Uniform;

constexpr double deg_per_rad = 180.0 / std::numbers::pi;

TEST(Alignment, HasTheFigureOfThePapersExample) {
  const auto moments = alignment_moments(Angle::deg(0.1));
  EXPECT_NEAR(1.0 + moments.mean * 1e-6, 0.9999994923043777, 1e-15);
  EXPECT_NEAR(moments.standard_deviation, 0.4540967397116412, 1e-14);
}

TEST(Alignment, KeepsAllDigitsFromANanoradianToARightAngle) {
  for (const auto& row : testing_support::golden_rows("uncertainty/alignment.csv")) {
    const auto moments = alignment_moments(Angle::deg(row[0] * deg_per_rad));
    EXPECT_NEAR(moments.mean, row[1] * 1e6, 2e-15 * std::abs(row[1] * 1e6)) << row[0];
    EXPECT_NEAR(moments.standard_deviation, row[2] * 1e6, 2e-15 * row[2] * 1e6) << row[0];
  }
  EXPECT_EQ(alignment_moments(Angle::deg(0)).standard_deviation, 0.0);
  const double right = std::numbers::pi / 2.0;
  EXPECT_NEAR(alignment_moments(Angle::deg(90)).mean, (1.0 / right - 1.0) * 1e6, 1e-8);
  EXPECT_NEAR(alignment_moments(Angle::deg(90)).standard_deviation, std::sqrt(0.5 - 1.0 / (right * right)) * 1e6, 1e-8);
}

TEST(Alignment, TakesAnyDistributionOfTheAngle) {
  const auto of = [](Distribution::Form form) {
    return alignment_moments(Distribution::make(std::move(form)).value());
  };
  EXPECT_EQ(of(Uniform{-0.1, 0.1}).standard_deviation, alignment_moments(Angle::deg(0.1)).standard_deviation);
  // cos θ has the same distribution for θ from 0 to θ_max.
  EXPECT_NEAR(of(Uniform{0.0, 0.1}).standard_deviation, 0.4540967397116412, 1e-4 * 0.454);
  // Normal with sd σ: E cos θ = exp(−σ²/2), E cos 2θ = exp(−2σ²).
  const double variance = std::pow(20.0 / deg_per_rad, 2.0);
  const double mean = std::exp(-variance / 2.0);
  EXPECT_NEAR(of(Normal{0.0, 20.0}).mean, (mean - 1.0) * 1e6, 1.0);
  EXPECT_NEAR(of(Normal{0.0, 20.0}).standard_deviation,
              std::sqrt((1.0 + std::exp(-2.0 * variance)) / 2.0 - mean * mean) * 1e6, 1.0);
  // θ = a sin φ: θ² has the variance a⁴/8, cos θ that over 4.
  EXPECT_NEAR(of(Arcsine{-0.1, 0.1}).standard_deviation, std::pow(0.1 / deg_per_rad, 2.0) / std::sqrt(32.0) * 1e6,
              1e-4);
  EXPECT_EQ(of(Constant{0.1}).standard_deviation, 0.0);
  EXPECT_NEAR(of(Constant{60.0}).mean, -5e5, 1e-8);
}

}  // namespace
}  // namespace axiometry
