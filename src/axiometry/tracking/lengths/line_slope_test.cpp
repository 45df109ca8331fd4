// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/line_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace axiometry::tracking {
namespace {

/// Targets measured upwards alone: means in µm every 100 mm, each of so many readings with that s in µm.
std::vector<iso230_2::PositionResult> targets_measured(const std::vector<double>& means, std::size_t count, double s) {
  std::vector<iso230_2::PositionResult> positions;
  for (const double mean : means) {
    iso230_2::PositionResult p;
    p.target = Position::native(100.0 * static_cast<double>(positions.size()));
    p.count_up = count;
    p.mean_up = Deviation::native(mean);
    if (count > 1) p.s_up = Deviation::native(s);
    positions.push_back(p);
  }
  return positions;
}

TEST(LineSlope, OfMeansThatScatterAboutTheLineHasTwoDegreesOfFreedomLessThanMeans) {
  const SlopeFit three = fit_slope(targets_measured({0, 3, 0}, 1, 0));
  EXPECT_NEAR(three.slope_um_per_m, 0.0, 1e-12);
  EXPECT_EQ(three.degrees_of_freedom, 1.0);
  EXPECT_NEAR(three.uncertainty_um_per_m, std::sqrt(6.0 / 20000.0) * 1000.0, 1e-9);  // Σr² = 6, Σp² = 20 000 mm²
  EXPECT_EQ(fit_slope(targets_measured({0, 3, 0, 3, 0}, 5, 0.01)).degrees_of_freedom, 3.0);
}

/// Of equal s at each of m targets: (Σp²)² / Σp⁴ times n − 1 degrees of freedom.
TEST(LineSlope, OfRepetitionHasThoseOfWelchAndSatterthwaite) {
  const SlopeFit fit = fit_slope(targets_measured({0, 10, 20}, 5, 2.0));
  EXPECT_NEAR(fit.slope_um_per_m, 100.0, 1e-9);
  EXPECT_NEAR(fit.uncertainty_um_per_m, 1000.0 * 2.0 / std::sqrt(5.0) / std::sqrt(20000.0), 1e-9);
  EXPECT_NEAR(fit.degrees_of_freedom, 2.0 * 4.0, 1e-9);  // both ends count alike, the middle not at all
}

TEST(LineSlope, OfTwoTargetsWithoutRepetitionHasNoUncertainty) {
  EXPECT_EQ(fit_slope(targets_measured({0, 5}, 1, 0)).uncertainty_um_per_m, 0.0);
}

}  // namespace
}  // namespace axiometry::tracking
