// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/residual_findings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "axiometry/model/station_bounds.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/tracking/station/length_difference.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::tracking {
namespace {

TEST(FewResiduals, TellHowBadlyTheyAreKnown) {
  const auto one = few_residuals_finding(9.0, 1);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->id, "tracking-residuals-few");
  EXPECT_FALSE(one->serious);
  EXPECT_TRUE(one->message.contains("ν = 1 only: 95 % needs 12.7 times")) << one->message;
  EXPECT_TRUE(few_residuals_finding(10.1, 10)->message.contains("2.23 times"));
}

TEST(FewResiduals, SayNothingWhereNothingWasMultipliedOrManyTellIt) {
  EXPECT_FALSE(few_residuals_finding(1.0, 1));
  EXPECT_FALSE(few_residuals_finding(0.3, 2));
  EXPECT_FALSE(few_residuals_finding(40.0, 11));
  EXPECT_FALSE(few_residuals_finding(0.0, 0));
}

/// Readings that scatter three times as much as was stated: u is 1 times √(χ²/ν), and what is said of it is true.
TEST(FewResiduals, NeedTheirFactor) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, 3.0);
  for (const int nu : {1, 2, 5}) {
    const double k = numeric::student_t_quantile(0.975, nu);
    int told = 0, held = 0, held_by_two = 0;
    while (told < 4000) {
      double chi_squared = 0.0;
      for (int i = 0; i < nu; ++i) chi_squared += std::pow(normal(random), 2.0);
      const double error = std::abs(normal(random));
      if (!few_residuals_finding(chi_squared, static_cast<std::size_t>(nu))) continue;
      const double u = std::sqrt(chi_squared / nu);
      ++told;
      held += error <= k * u;
      held_by_two += error <= 2.0 * u;
    }
    EXPECT_GT(held, 0.94 * told) << nu;
    EXPECT_LT(held_by_two, 0.93 * told) << nu;
  }
}

TEST(WideningForBounds, IsOneWhereNothingIsKnownOrVeryManyTellTheStatementRight) {
  EXPECT_EQ(widening_for_bounds(0.0, 0), 1.0);
  EXPECT_EQ(widening_for_bounds(0.001, 2), 1.0) << "small residuals do not take away what was stated";
  EXPECT_NEAR(widening_for_bounds(2.0, 2), 19.0 * 2.0 / 5.991464547, 1e-8) << "F(2, 2) is 19 at 95 %, χ² of two 5.99";
  EXPECT_NEAR(widening_for_bounds(1e6, 1'000'000), 1.0, 1e-5);
  EXPECT_NEAR(widening_for_bounds(4e6, 1'000'000), 4.0, 1e-4);
}

/// Bounds of length differences by a station whose readings scatter as stated or much more.
TEST(WideningForBounds, HoldsHoweverMuchMoreThanStatedReadingsScatter) {
  constexpr int sets = 4000;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (const int nu : {1, 2, 3, 6, 10})
    for (const double smaller : {0.0, 0.6, 1.0})
      for (const double scatter : {1.0, 1.5, 5.0}) {
        const double q = squared_offset_quantile_mm2({1.0, smaller}, 0.95);
        int held = 0, held_by_normal = 0;
        for (int set = 0; set < sets; ++set) {
          double chi_squared = 0.0;
          for (int i = 0; i < nu; ++i) chi_squared += std::pow(scatter * normal(random), 2.0);
          const double offset =
              std::pow(scatter * normal(random), 2.0) + std::pow(smaller * scatter * normal(random), 2.0);
          held += offset <= q * widening_for_bounds(chi_squared, static_cast<std::size_t>(nu));
          held_by_normal += offset <= q * std::max(1.0, chi_squared / nu);
        }
        EXPECT_GT(held, 0.94 * sets) << nu << " " << smaller << " " << scatter;
        if (scatter == 5.0 && nu <= 3) EXPECT_LT(held_by_normal, 0.9 * sets) << nu << " " << smaller;
      }
}

/// Six points that the machine comes to within 5 µm where 0.2 µm + 0.3 µm/m is all that is stated.
TEST(WideningForBounds, HoldsForStationsThatSixPointsTell) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  constexpr int sets = 300;
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  const Vector3 at{300.0, 250.0, -400.0};
  const std::vector<double> distances{300.0, 900.0};
  int held = 0, held_by_normal = 0, lines = 0;
  for (int set = 0; set < sets; ++set) {
    std::vector<LocationPoint> points;
    std::uniform_real_distribution<double> place(0.0, 600.0);
    for (int i = 0; i < 6; ++i) {
      const Vector3 told{place(random), place(random), place(random)};
      const Vector3 error{0.005 * normal(random), 0.005 * normal(random), 0.005 * normal(random)};
      points.push_back({told, distance(told + error, at)});
    }
    const double first = points.front().length_difference_mm;
    for (LocationPoint& p : points) p.length_difference_mm -= first;
    const auto located = locate_station(points, {.near_mm = at});
    if (!located) continue;
    const RefinedFit& fit = located->refined;
    const double widening = widening_for_bounds(fit.chi_squared, fit.degrees_of_freedom);
    Matrix3 wide = fit.covariance_stated_mm2;
    for (auto& row : wide)
      for (double& x : row) x *= widening;
    for (const Vector3 direction : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
      const double error =
          std::abs(length_differences(fit.station_mm - at, direction, distances, 1).front().difference.in_mm());
      const auto bound = [&](const Matrix3& covariance) {
        return length_difference_bounds(offset_uncertainty(covariance, direction), distances, 1).front().in_mm();
      };
      held += error <= bound(wide);
      held_by_normal += error <= bound(fit.covariance_mm2);
      ++lines;
    }
  }
  EXPECT_GT(lines, 800);
  EXPECT_GT(held, 0.93 * lines);
  EXPECT_LT(held_by_normal, 0.88 * lines) << "a normal station with its covariance times χ²/ν does not";
}

}  // namespace
}  // namespace axiometry::tracking
