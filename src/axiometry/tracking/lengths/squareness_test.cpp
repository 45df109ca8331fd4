// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/squareness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/statistics_of_trials.h"

namespace axiometry::tracking {
namespace {

/// A machine of straight axes: scales and squareness in µm/m, as ISO 230-1 defines their signs.
struct Machine {
  double e_x = 0.0, e_y = 0.0, e_z = 0.0, C0Y = 0.0, B0Z = 0.0, A0Z = 0.0;

  /// Where the tool really is when it was sent to p: each axis goes along its own, tilted direction.
  Vector3 actual(Vector3 p) const {
    const double c = C0Y * 1e-6, b = B0Z * 1e-6, a = A0Z * 1e-6;
    const Vector3 x_axis{1.0, 0.0, 0.0};
    const Vector3 y_axis{-std::sin(c), std::cos(c), 0.0};  // Y turned by +c about Z
    Vector3 z_axis{std::sin(b), -std::sin(a), 0.0};        // Z turned by +b about Y and +a about X
    z_axis.z = std::sqrt(1.0 - z_axis.x * z_axis.x - z_axis.y * z_axis.y);
    return (1.0 + e_x * 1e-6) * p.x * x_axis + (1.0 + e_y * 1e-6) * p.y * y_axis + (1.0 + e_z * 1e-6) * p.z * z_axis;
  }
  double stretch_um_per_m(Vector3 begin, Vector3 end) const {
    const double nominal = distance(begin, end);
    return (distance(actual(begin), actual(end)) - nominal) / nominal * 1e6;
  }
  std::array<double, 6> terms() const { return {e_x, e_y, e_z, C0Y, B0Z, A0Z}; }
};

LineSlope line(const Machine& machine, std::string id, Vector3 direction, double u = 0.5) {
  const Vector3 begin{100, -40, 30};
  const Vector3 d = unit(direction);
  return {std::move(id), d, machine.stretch_um_per_m(begin, begin + 400.0 * d), u};
}

std::vector<LineSlope> seven_lines(const Machine& machine, double u = 0.5) {
  return {line(machine, "x", {1, 0, 0}, u),  line(machine, "y", {0, 1, 0}, u),  line(machine, "z", {0, 0, 1}, u),
          line(machine, "xy", {1, 1, 0}, u), line(machine, "xz", {1, 0, 1}, u), line(machine, "yz", {0, 1, 1}, u),
          line(machine, "xyz", {1, 1, 1}, u)};
}

TEST(Squareness, FindsEachTermOfAMachineWithItsSign) {
  for (std::size_t k = 0; k < 6; ++k) {
    std::array<double, 6> t{};
    t[k] = 25.0;
    const Machine machine{t[0], t[1], t[2], t[3], t[4], t[5]};
    const ScalesAndSquareness found = estimate_squareness(seven_lines(machine), 0.0);
    EXPECT_EQ(found.rank, 6u);
    for (std::size_t m = 0; m < 6; ++m) {
      ASSERT_TRUE(found.terms[m].value_um_per_m);
      EXPECT_NEAR(*found.terms[m].value_um_per_m, t[m], 0.003) << found.terms[m].id;  // second order: 25² 1e-6
    }
  }
}

TEST(Squareness, FindsAllTermsTogetherInAnyOctant) {
  const Machine machine{-30, 70, 12, 18, -22, 35};
  std::vector<LineSlope> slopes = seven_lines(machine);
  slopes[3] = line(machine, "xy", {-1, 1, 0});
  slopes[4] = line(machine, "xz", {-1, 0, -1});
  slopes[5] = line(machine, "yz", {0, 2, -1});
  slopes[6] = line(machine, "xyz", {3, -2, 1});
  const ScalesAndSquareness found = estimate_squareness(slopes, 0.0);
  for (std::size_t m = 0; m < 6; ++m)
    EXPECT_NEAR(*found.terms[m].value_um_per_m, machine.terms()[m], 0.02) << found.terms[m].id;
  EXPECT_EQ(found.degrees_of_freedom, 1u);
  for (double residual : found.residuals_um_per_m) EXPECT_NEAR(residual, 0.0, 0.01);
}

TEST(Squareness, ComesFromFourBodyDiagonalsWithoutAnyScale) {
  const Machine machine{-30, 70, 12, 18, -22, 35};
  const Vector3 box{1000, 600, 500};
  const std::vector<LineSlope> slopes = {
      line(machine, "NNN-PPP", {box.x, box.y, box.z}), line(machine, "NNP-PPN", {box.x, box.y, -box.z}),
      line(machine, "NPN-PNP", {box.x, -box.y, box.z}), line(machine, "NPP-PNN", {box.x, -box.y, -box.z})};
  const ScalesAndSquareness found = estimate_squareness(slopes, 2.0);
  EXPECT_EQ(found.rank, 4u);
  EXPECT_EQ(found.degrees_of_freedom, 0u);
  for (std::size_t m = 0; m < 3; ++m) EXPECT_FALSE(found.terms[m].value_um_per_m) << found.terms[m].id;
  for (std::size_t m = 3; m < 6; ++m) {
    ASSERT_TRUE(found.terms[m].value_um_per_m) << found.terms[m].id;
    EXPECT_NEAR(*found.terms[m].value_um_per_m, machine.terms()[m], 0.02) << found.terms[m].id;
  }
  // C0Y = Σ ± slope/(4 u_x u_y): u = 0.5 · 2/(4 u_x u_y)
  const double product = 1000.0 * 600.0 / dot(box, box);
  EXPECT_NEAR(*found.terms[3].uncertainty_um_per_m, 0.25 / product, 1e-12);
}

TEST(Squareness, LeavesOutWhatTheLinesCannotTell) {
  const Machine machine{-30, 70, 12, 18, -22, 35};
  const std::vector<LineSlope> one = {line(machine, "x", {1, 0, 0})};
  const ScalesAndSquareness of_x = estimate_squareness(one, 0.0);
  EXPECT_EQ(of_x.rank, 1u);
  EXPECT_NEAR(*of_x.terms[0].value_um_per_m, -30.0, 1e-6);
  for (std::size_t m = 1; m < 6; ++m) EXPECT_FALSE(of_x.terms[m].value_um_per_m);

  const std::vector<LineSlope> two = {line(machine, "x", {1, 0, 0}), line(machine, "xy", {1, 1, 0})};
  EXPECT_TRUE(estimate_squareness(two, 0.0).terms[0].value_um_per_m);
  EXPECT_FALSE(estimate_squareness(two, 0.0).terms[3].value_um_per_m);  // with e_y in one

  // Two face diagonals that cross tell the squareness of their plane without any axis.
  const std::vector<LineSlope> faces = {line(machine, "NN0-PP0", {5, 3, 0}), line(machine, "NP0-PN0", {5, -3, 0})};
  const ScalesAndSquareness crossed = estimate_squareness(faces, 0.0);
  EXPECT_EQ(crossed.rank, 2u);
  EXPECT_NEAR(*crossed.terms[3].value_um_per_m, 18.0, 0.01);
  EXPECT_FALSE(crossed.terms[0].value_um_per_m);
  EXPECT_THAT(crossed.notes, testing::Contains(testing::HasSubstr("e_x, e_y, e_z, B0Z, A0Z cannot be told")));

  const ScalesAndSquareness nothing = estimate_squareness({}, 0.0);
  EXPECT_EQ(nothing.rank, 0u);
  EXPECT_EQ(nothing.terms[0].id, "e_x");
  EXPECT_FALSE(nothing.terms[0].value_um_per_m);
}

TEST(Squareness, TakesLinesThatAreAlmostTheSameAsOne) {
  const Machine machine{};
  std::vector<LineSlope> slopes = seven_lines(machine);
  slopes.resize(5);
  slopes.push_back(line(machine, "xy again", {1.0, 1.000001, 0}));
  slopes.push_back(line(machine, "xz again", {1.0, 1e-6, 1.0}));
  const ScalesAndSquareness found = estimate_squareness(slopes, 0.0);
  EXPECT_EQ(found.rank, 5u);
  EXPECT_TRUE(found.terms[4].value_um_per_m);
  EXPECT_FALSE(found.terms[5].value_um_per_m);
}

TEST(Squareness, PutsTheScaleOfTheInstrumentIntoTheScalesAlone) {
  const std::vector<LineSlope> slopes = seven_lines({10, 20, 30, 5, 6, 7});
  const ScalesAndSquareness without = estimate_squareness(slopes, 0.0);
  const ScalesAndSquareness with = estimate_squareness(slopes, 3.0);
  for (std::size_t m = 0; m < 6; ++m) {
    const double common = m < 3 ? 3.0 : 0.0;
    EXPECT_NEAR(*with.terms[m].uncertainty_um_per_m, std::hypot(*without.terms[m].uncertainty_um_per_m, common), 1e-12);
    EXPECT_EQ(*with.terms[m].value_um_per_m, *without.terms[m].value_um_per_m);
  }
  EXPECT_NEAR(with.covariance_um2_per_m2[0][1] - without.covariance_um2_per_m2[0][1], 9.0, 1e-12);
  EXPECT_NEAR(with.covariance_um2_per_m2[0][3], without.covariance_um2_per_m2[0][3], 1e-12);
}

/// Three targets measured once tell u of a slope with one degree of freedom: 2 u held the truth in 75 % of trials.
TEST(Squareness, HoldsWithAnUncertaintyThatIsItselfKnownFromFewTargets) {
  const Machine machine{-30, 70, 12, 18, -22, 35};
  const std::vector<LineSlope> exact = seven_lines(machine);
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  constexpr int trials = 2000;
  std::array<int, 6> held{};
  for (int t = 0; t < trials; ++t) {
    std::vector<LineSlope> slopes = exact;
    for (LineSlope& slope : slopes) {
      slope.slope_um_per_m += normal(random);
      slope.uncertainty_um_per_m = std::abs(normal(random));
      slope.degrees_of_freedom = 1.0;
    }
    const ScalesAndSquareness found = estimate_squareness(slopes, 0.0);
    for (std::size_t m = 0; m < 6; ++m)
      held[m] += std::abs(*found.terms[m].value_um_per_m - machine.terms()[m]) <=
                 found.terms[m].coverage_factor * *found.terms[m].uncertainty_um_per_m;
  }
  for (const int count : held) EXPECT_GT(count / static_cast<double>(trials), 0.94);
  std::vector<LineSlope> badly_known = exact;
  for (LineSlope& slope : badly_known) slope.uncertainty_um_per_m = 1.0, slope.degrees_of_freedom = 1.0;
  const ScalesAndSquareness known_from_few = estimate_squareness(badly_known, 0.0);
  EXPECT_GT(known_from_few.terms[0].coverage_factor, 13.9) << "line x tells the scale of X nearly alone";
  for (std::size_t m = 3; m < 6; ++m) {
    EXPECT_GT(known_from_few.terms[m].coverage_factor, 2.4) << "seven slopes have 7 degrees of freedom at most";
    EXPECT_LT(known_from_few.terms[m].coverage_factor, 13.0) << "more than one slope tells a squareness";
  }
  EXPECT_EQ(estimate_squareness(exact, 0.0).terms[0].coverage_factor, 2.0) << "nothing says that u is badly known";
}

/// With weights 1/u² of u that two degrees of freedom tell, three such lines held the truth in 90 % and eight in 77 %.
TEST(Squareness, HoldsWhereManyLinesOfFewTargetsTellOneTerm) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  constexpr int trials = 3000;
  for (const double noise_of_others : {1.0, 3.0})
    for (const double degrees : {1.0, 2.0, 9.0})
      for (const std::size_t lines : {3, 5, 8, 15}) {
        std::chi_squared_distribution<double> squares(degrees);
        int held = 0;
        for (int t = 0; t < trials; ++t) {
          std::vector<LineSlope> slopes;
          for (std::size_t i = 0; i < lines; ++i) {
            const double noise = i % 2 ? noise_of_others : 1.0;
            slopes.push_back({.id = "x",
                              .direction = {1, 0, 0},
                              .slope_um_per_m = 5.0 + noise * normal(random),
                              .uncertainty_um_per_m = noise * std::sqrt(squares(random) / degrees),
                              .degrees_of_freedom = degrees});
          }
          const SquarenessTerm found = estimate_squareness(slopes, 0.0).terms[0];
          held += std::abs(*found.value_um_per_m - 5.0) <= found.coverage_factor * *found.uncertainty_um_per_m;
        }
        EXPECT_GT(held / static_cast<double>(trials), 0.93) << lines << " lines, ν = " << degrees;
      }
}

TEST(Squareness, WeighsLinesWhoseUncertaintyIsKnownByItAlone) {
  const std::vector<LineSlope> known = {
      {.id = "a", .direction = {1, 0, 0}, .slope_um_per_m = 1.0, .uncertainty_um_per_m = 1.0},
      {.id = "b", .direction = {1, 0, 0}, .slope_um_per_m = 6.0, .uncertainty_um_per_m = 2.0}};
  EXPECT_NEAR(*estimate_squareness(known, 0.0).terms[0].value_um_per_m, 2.0, 1e-12);
  std::vector<LineSlope> of_few = known;
  for (LineSlope& slope : of_few) slope.degrees_of_freedom = 2.0;
  // u² of both together is 2.5, which counts as eight degrees of freedom: (8·2.5 + 2·1)/10 and (8·2.5 + 2·4)/10.
  EXPECT_NEAR(*estimate_squareness(of_few, 0.0).terms[0].value_um_per_m,
              (1.0 / 2.2 + 6.0 / 2.8) / (1.0 / 2.2 + 1.0 / 2.8), 1e-12);
}

TEST(Squareness, StatesUncertaintiesThatHoldInManyTrials) {
  const Machine machine{-30, 70, 12, 18, -22, 35};
  const std::vector<LineSlope> exact = seven_lines(machine);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr int trials = 4000;
  std::array<double, 6> squares{};
  double chi = 0.0;
  for (int t = 0; t < trials; ++t) {
    std::vector<LineSlope> slopes = exact;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      slopes[i].uncertainty_um_per_m = i < 3 ? 0.4 : 1.5;
      slopes[i].slope_um_per_m += slopes[i].uncertainty_um_per_m * normal(random);
    }
    const ScalesAndSquareness found = estimate_squareness(slopes, 0.0);
    const double inflation = std::max(1.0, found.chi_squared);  // ν is 1
    for (std::size_t m = 0; m < 6; ++m) {
      const double z = (*found.terms[m].value_um_per_m - machine.terms()[m]) * std::sqrt(inflation) /
                       *found.terms[m].uncertainty_um_per_m;
      squares[m] += z * z / trials;
    }
    chi += found.chi_squared / trials;
  }
  for (double mean_square : squares) EXPECT_NEAR(mean_square, 1.0, 0.1);
  EXPECT_NEAR(chi, 1.0, 0.1);
}

TEST(Squareness, SaysWhenTheLinesContradictEachOther) {
  std::vector<LineSlope> slopes = seven_lines({});
  slopes[6].slope_um_per_m = 10.0;
  const ScalesAndSquareness found = estimate_squareness(slopes, 0.0);
  EXPECT_GT(found.chi_squared, 3.9);
  EXPECT_THAT(found.notes, testing::Contains(testing::HasSubstr("contradict")));
  const ScalesAndSquareness agreed = estimate_squareness(seven_lines({}), 0.0);
  EXPECT_NEAR(*found.terms[3].uncertainty_um_per_m,
              *agreed.terms[3].uncertainty_um_per_m * std::sqrt(found.chi_squared), 1e-9);
  EXPECT_THAT(agreed.notes, testing::Not(testing::Contains(testing::HasSubstr("contradict"))));
}

TEST(Squareness, CountsAllLinesAlikeWhereAnUncertaintyIsNotKnown) {
  const Machine machine{-30, 70, 12, 18, -22, 35};
  for (double unknown : {0.0, -1.0, std::nan("")}) {
    std::vector<LineSlope> slopes = seven_lines(machine);
    slopes[2].uncertainty_um_per_m = unknown;
    const ScalesAndSquareness found = estimate_squareness(slopes, 1.0);
    EXPECT_FALSE(found.weighted);
    EXPECT_NEAR(*found.terms[4].value_um_per_m, -22.0, 0.02);
    EXPECT_FALSE(found.terms[4].uncertainty_um_per_m);
    EXPECT_EQ(found.chi_squared, 0.0);
  }
}

TEST(Squareness, WarnsOfShortLines) {
  std::vector<LineSlope> slopes = seven_lines({});
  EXPECT_THAT(estimate_squareness(slopes, 0.0).notes, testing::Not(testing::Contains(testing::HasSubstr("mm long"))));
  slopes[1].length_mm = 800.0;
  slopes[4].length_mm = 125.0;
  EXPECT_THAT(estimate_squareness(slopes, 0.0).notes,
              testing::Contains(testing::HasSubstr("Line xz is 125 mm long: 1 µm of straightness at one of its ends is "
                                                   "8 µm/m")));
}

}  // namespace
}  // namespace axiometry::tracking
