// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/face_pairs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace axiometry::tracking {
namespace {

/// Validation: the diagonals of a parallelogram with the legs a and b whose angle is 90° + S, by their ends.
LineSlope slope_of(const std::string& id, double a, double b, double s, double scale) {
  const Vector3 first{a, 0.0, 0.0}, second{-b * std::sin(s), b * std::cos(s), 0.0};
  const bool rises = id == "NN0-PP0";
  const double length = (1.0 + scale) * norm(rises ? first + second : first - second), nominal = std::hypot(a, b);
  return {id, {a, rises ? b : -b, 0.0}, 1e6 * (length / nominal - 1.0), 0.3, nominal};
}

TEST(FacePairs, TellTheAngleOfTheAxesWhateverTheirScale) {
  for (const double scale : {0.0, 100e-6}) {
    const LineSlope slopes[] = {slope_of("NP0-PN0", 800, 500, 35e-6, scale),
                                slope_of("NN0-PP0", 800, 500, 35e-6, scale)};
    const auto pairs = face_pairs(slopes);
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].face, "XY");
    EXPECT_EQ(pairs[0].term, "C0Y");
    EXPECT_NEAR(pairs[0].squareness_um_per_m, 35.0, 0.01);
    EXPECT_NEAR(*pairs[0].uncertainty_um_per_m, 0.3 * std::sqrt(2.0) * (800.0 * 800 + 500.0 * 500) / (2 * 800 * 500),
                1e-9);
  }
}

TEST(FacePairs, HaveTheSignsOfTheLeastSquares) {
  const std::pair<const char*, Vector3> lines[] = {{"NN0-PP0", {4, 3, 0}}, {"NP0-PN0", {4, -3, 0}},
                                                   {"N0N-P0P", {2, 0, 5}}, {"N0P-P0N", {2, 0, -5}},
                                                   {"0NN-0PP", {0, 1, 2}}, {"0NP-0PN", {0, 1, -2}}};
  std::vector<LineSlope> slopes;
  for (const auto& [id, direction] : lines) {
    const Vector3 u = unit(direction);
    slopes.push_back(
        {id, direction, 11.0 * u.x * u.x - 7.0 * u.x * u.y + 5.0 * u.x * u.z - 3.0 * u.y * u.z, 0.1, 1000});
  }
  const auto pairs = face_pairs(slopes);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_NEAR(pairs[0].squareness_um_per_m, 7.0, 1e-12);
  EXPECT_NEAR(pairs[1].squareness_um_per_m, 5.0, 1e-12);
  EXPECT_NEAR(pairs[2].squareness_um_per_m, 3.0, 1e-12);
  const ScalesAndSquareness all = estimate_squareness(slopes, 0.0);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(*all.terms[3 + k].value_um_per_m, 7.0 - 2.0 * static_cast<double>(k), 1e-9);
}

TEST(FacePairs, AreNoneOfLinesThatGoAnotherWayThanTheyAreNamed) {
  const Vector3 rising{800, 500, 0}, falling{800, -500, 0};
  const std::pair<Vector3, Vector3> wrong[] = {
      {{1, 0, 0}, {1, 0, 0}},     {rising, rising},          {falling, rising},         {rising, {800, -400, 0}},
      {{800, 500, 200}, falling}, {rising, {800, -500, 20}}, {{1, 1e-17, 0}, {1, 0, 0}}};
  for (const auto& [first, second] : wrong) {
    const LineSlope slopes[] = {{"NN0-PP0", first, 3.0, 0.1, 900}, {"NP0-PN0", second, 1.0, 0.1, 900}};
    EXPECT_TRUE(face_pairs(slopes).empty()) << first.y << " " << second.y;
  }
  const LineSlope thin[] = {{"NN0-PP0", {2000, 1, 0}, 3.0, 0.1, 900}, {"NP0-PN0", {2000, -1, 0}, 1.0, 0.1, 900}};
  EXPECT_EQ(face_pairs(thin).size(), 1u);
}

TEST(FacePairs, AreNoneWhereADiagonalIsMissingAndHaveNoUncertaintyWhereOneIsNotKnown) {
  LineSlope lone = slope_of("NN0-PP0", 8, 5, 0, 0), other = slope_of("NP0-PN0", 8, 5, 0, 0);
  EXPECT_TRUE(face_pairs(std::span(&lone, 1)).empty());
  other.uncertainty_um_per_m = 0.0;
  const LineSlope both[] = {lone, other};
  EXPECT_FALSE(face_pairs(both)[0].uncertainty_um_per_m);
}

}  // namespace
}  // namespace axiometry::tracking
