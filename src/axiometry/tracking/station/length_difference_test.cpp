// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/length_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "axiometry/numeric/random/random.h"

namespace axiometry::tracking {
namespace {

constexpr Vector3 x_axis = {1, 0, 0}, y_axis = {0, 1, 0}, z_axis = {0, 0, 1};
constexpr Vector3 paper_error_mm = {0.7978, 0.2715, 0.1965};

/// Of Figs 11 to 13, computed outside this project with the corrected signs: d in mm, α in °, Δd in mm of x, y, z, and
/// eq. 23.
struct Golden {
  double d, alpha_x, x, alpha_y, y, alpha_z, z, combined;
};
// clang-format off
const std::vector<Golden> golden = {
    {10, 1.7778093787881, 0.0051489961497583, 4.5734940383091,
     0.032503444610194, 4.7247082586325, 0.034443503629658, 0.047637600854414},
    {20, 0.92321933956669, 0.0026491989177505, 2.3210377756482,
     0.016337764886573, 2.3893738204967, 0.017251776672536, 0.023907417567646},
    {30, 0.62348074045882, 0.0017725063592863, 1.5547665657339,
     0.010841864781316, 1.598610840273, 0.011434544767497, 0.015856753285901},
    {40, 0.47066658407845, 0.0013255571532679, 1.1688201618884,
     0.008074163373018, 1.2010475966212, 0.0085103365921674, 0.011805720852737},
    {50, 0.37801468730436, 0.0010545723648753, 0.93636514649672,
     0.0064072762025085, 0.96182894341958, 0.006750911849519, 0.0093669697345496},
    {60, 0.3158403527451, 0.00087272803822331, 0.78102844154969,
     0.0052934202445947, 0.80207035635437, 0.0055759417271253, 0.0077377695920003},
    {70, 0.27122946847752, 0.00074225273766316, 0.66989500022031,
     0.0044965406736783, 0.68782151210883, 0.0047356946284136, 0.0065724136183138},
    {80, 0.23766096318897, 0.00064407370086274, 0.58644758921076,
     0.003898189114603, 0.60206125126102, 0.0041049745063177, 0.0056975016457102},
    {90, 0.21148646656664, 0.00056752027563459, 0.52148653450418,
     0.0034323952983944, 0.53531542066093, 0.0036140986560644, 0.0050164854074803},
    {100, 0.19050537153823, 0.00050615621263805, 0.46948153809485,
     0.0030595027646341, 0.48189152093087, 0.003221199617575, 0.0044713396487699},
    {200, 0.095631402688541, 0.00022867576306524, 0.23506293970392,
     0.0013786610776538, 0.24118651979271, 0.0014509830027092, 0.0020145348460134},
    {300, 0.063838848410033, 0.00013569132872635, 0.15677996132735,
     0.00081735581131238, 0.16084416530954, 0.00086012553994682, 0.0011942774398968},
    {400, 0.047910913250599, 8.9106532300485e-05, 0.11761168489859,
     0.00053651153462835, 0.12065300656144, 0.00056455033234906, 0.00078390157458913},
    {500, 0.038343998787146, 6.1125961375824e-05, 0.09410216117443,
     0.00036794370585306, 0.096531936198912, 0.00038715843318726, 0.00053759706678796},
    {600, 0.031961819951231, 4.2459859603161e-05, 0.078425582844624,
     0.0002555396418655, 0.080448570727261, 0.00026887770035048, 0.0003733611736483},
    {700, 0.027401044407659, 2.9120857306811e-05, 0.067226283020018,
     0.00017523853395099, 0.068959155032503, 0.00018438193503923, 0.0002560337205924},
    {800, 0.023979326593286, 1.9113282810648e-05, 0.058825854864867,
     0.00011500587389609, 0.060341384222298, 0.0001210049034065, 0.00016802932856743},
    {900, 0.021317316956696, 1.1327643873184e-05, 0.052291623784805,
     6.8154203304324e-05, 0.053638253654274, 7.1708571770546e-05, 9.9576253239095e-05},
    {1000, 0.019187284768928, 5.0978912903604e-06, 0.047063883220707,
     3.0670318164732e-05, 0.04827548475252, 3.2269563616541e-05, 4.4810508231175e-05},
    {1100, 0.017444250442009, 0, 0.042786405811802,
     0, 0.043887589960504, 0, 0},
};
// clang-format on

std::vector<double> paper_distances() {
  std::vector<double> list;
  for (const Golden& g : golden) list.push_back(g.d);
  return list;
}

TEST(LengthDifference, IsThatOfThePapersFigures) {
  const auto d = paper_distances();
  const std::size_t last = d.size() - 1;
  const auto x = length_differences(paper_error_mm, x_axis, d, last);
  const auto y = length_differences(paper_error_mm, y_axis, d, last);
  const auto z = length_differences(paper_error_mm, z_axis, d, last);
  const auto combined = combined_length_differences(paper_error_mm, d, last);
  for (std::size_t k = 0; k < d.size(); ++k) {
    EXPECT_NEAR(x[k].alpha.in_deg(), golden[k].alpha_x, 1e-12);
    EXPECT_NEAR(y[k].alpha.in_deg(), golden[k].alpha_y, 1e-12);
    EXPECT_NEAR(z[k].alpha.in_deg(), golden[k].alpha_z, 1e-12);
    EXPECT_NEAR(x[k].difference.in_mm(), golden[k].x, 1e-12);
    EXPECT_NEAR(y[k].difference.in_mm(), golden[k].y, 1e-12);
    EXPECT_NEAR(z[k].difference.in_mm(), golden[k].z, 1e-12);
    EXPECT_NEAR(combined[k].in_mm(), golden[k].combined, 1e-12);
  }
  EXPECT_EQ(y[last].difference.in_mm(), 0.0) << "eq. 21 as printed gives -0.614 µm here";
}

std::vector<double> uniform(std::size_t count, std::uint64_t stream) {
  std::vector<double> numbers(count);
  numeric::fill_uniform({1, stream, 0}, numbers);
  return numbers;
}

TEST(LengthDifference, IsTheDifferenceOfDistancesForAnyLineAndAnyError) {
  const auto u = uniform(6 * 200, 1);
  const std::vector<double> d = {0.5, 10, 47, 300, 1100, 12'000};
  for (std::size_t k = 0; k < u.size(); k += 6) {
    const Vector3 error = {4 * u[k] - 2, 4 * u[k + 1] - 2, 4 * u[k + 2] - 2};
    const Vector3 direction = unit({u[k + 3] - 0.5, u[k + 4] - 0.5, u[k + 5] - 0.5});
    const auto found = length_differences(error, direction, d, 3);
    for (std::size_t i = 0; i < d.size(); ++i) {
      // Reflector at determined station + d·u, actual station at determined − Δ; in more digits than double has.
      const long double dx = direction.x, dy = direction.y, dz = direction.z,
                        length = sqrtl(dx * dx + dy * dy + dz * dz);
      const auto actual = [&](double at) {
        const long double t = at / length, a = t * dx + error.x, b = t * dy + error.y, c = t * dz + error.z;
        return sqrtl(a * a + b * b + c * c);
      };
      const long double expected = (actual(d[i]) - actual(d[3])) - (static_cast<long double>(d[i]) - d[3]);
      EXPECT_NEAR(found[i].difference.in_mm(), static_cast<double>(expected), 1e-12) << i;
    }
  }
}

TEST(LengthDifference, HoldsWhereTheStationWasDeterminedBeyondTheTarget) {
  const auto found = length_differences({-20, 3, 0}, x_axis, std::vector<double>{10, 1000}, 1);
  EXPECT_NEAR(found[0].difference.in_mm(), (std::hypot(10, 3) - std::hypot(980, 3)) - (10 - 1000), 1e-12);
  EXPECT_GT(found[0].alpha.in_deg(), 90.0);
  EXPECT_EQ(length_differences({-10, 0, 0}, x_axis, std::vector<double>{10, 20}, 1)[0].difference.in_mm(), 0.0);
}

TEST(LengthDifference, VanishesWithAnErrorAlongTheLine) {
  for (const auto& k : length_differences({3, 0, 0}, x_axis, std::vector<double>{1, 10, 100}, 2)) {
    EXPECT_EQ(k.difference.in_mm(), 0.0);
    EXPECT_EQ(k.alpha.in_deg(), 0.0);
  }
}

TEST(OffsetUncertainty, IsWhatTheCovarianceShowsAcrossTheLine) {
  const Matrix3 covariance = {{{4, 0, 0}, {0, 9, 0}, {0, 0, 1}}};
  EXPECT_DOUBLE_EQ(offset_uncertainty(covariance, x_axis).larger_mm, 3.0);
  EXPECT_DOUBLE_EQ(offset_uncertainty(covariance, x_axis).smaller_mm, 1.0);
  EXPECT_DOUBLE_EQ(offset_uncertainty(covariance, y_axis).larger_mm, 2.0);
  // An error along (1, 1, 0) alone is seen from x with its part along y, and not at all along itself.
  const Matrix3 oblique = {{{1, 1, 0}, {1, 1, 0}, {0, 0, 0}}};
  EXPECT_NEAR(offset_uncertainty(oblique, x_axis).larger_mm, 1.0, 1e-15);
  EXPECT_NEAR(offset_uncertainty(oblique, unit({1, 1, 0})).larger_mm, 0.0, 1e-7);
}

TEST(OffsetUncertainty, HasTheQuantilesOfChiSquaredAtItsEnds) {
  // χ² of one and two degrees of freedom, from tables to sixteen digits.
  EXPECT_NEAR(squared_offset_quantile_mm2({1.0, 0.0}, 0.95), 3.841458820694124, 1e-12);
  EXPECT_NEAR(squared_offset_quantile_mm2({1.0, 1.0}, 0.95), 5.991464547107979, 1e-12);
  EXPECT_NEAR(squared_offset_quantile_mm2({0.01, 0.0}, 0.99), 6.634896601021214e-4, 1e-15);
  EXPECT_EQ(squared_offset_quantile_mm2({0.0, 0.0}, 0.95), 0.0);
}

TEST(OffsetUncertainty, HoldsAsManyTrialsAsItSays) {
  constexpr std::size_t trials = 400'000;
  std::vector<double> z(2 * trials);
  numeric::fill_normal({5, 1, 0}, z);
  for (const double smaller : {0.02, 0.3, 0.7, 0.95})
    for (const double p : {0.5, 0.95, 0.999}) {
      const double q = squared_offset_quantile_mm2({2.0, 2.0 * smaller}, p);
      std::size_t held = 0;
      for (std::size_t k = 0; k < trials; ++k)
        held += 4.0 * z[2 * k] * z[2 * k] + 4.0 * smaller * smaller * z[2 * k + 1] * z[2 * k + 1] <= q;
      const double error = std::sqrt(p * (1.0 - p) / trials);
      EXPECT_NEAR(static_cast<double>(held) / trials, p, 4.5 * error) << smaller << " " << p;
    }
}

TEST(LengthDifferenceBounds, HoldNineteenOfTwentyStations) {
  constexpr std::size_t trials = 100'000;
  const OffsetUncertainty offset{0.05, 0.02};
  const std::vector<double> d = {20, 300, 1100};
  const auto bounds = length_difference_bounds(offset, d, 2);
  std::vector<double> z(3 * trials);
  numeric::fill_normal({6, 1, 0}, z);
  std::array<std::size_t, 2> held{};
  for (std::size_t k = 0; k < trials; ++k) {
    const Vector3 error = {0.05 * z[3 * k], 0.05 * z[3 * k + 1], 0.02 * z[3 * k + 2]};
    const auto found = length_differences(error, x_axis, d, 2);
    for (std::size_t i = 0; i < 2; ++i) held[i] += std::abs(found[i].difference.in_mm()) <= bounds[i].in_mm();
  }
  EXPECT_NEAR(static_cast<double>(held[0]) / trials, 0.95, 0.003);
  EXPECT_NEAR(static_cast<double>(held[1]) / trials, 0.95, 0.003);
  EXPECT_EQ(bounds[2].in_mm(), 0.0);
}

TEST(NegligibleFrom, IsWhereTheBoundMeetsTheFraction) {
  const OffsetUncertainty offset{0.3, 0.1};
  const RangingUncertainty ranging;
  const double d = negligible_from_mm(offset, ranging, 1.0 / 3.0);
  EXPECT_NEAR(length_difference_bounds(offset, std::vector<double>{d, 1e15}, 1)[0].in_mm(),
              2.0 * ranging.standard_mm(d) / 3.0, 1e-12);
  EXPECT_EQ(negligible_from_mm({}, ranging, 1.0 / 3.0), 0.0);
  const RangingUncertainty constant{Length::um(0.2), {}}, none{{}, {}};
  EXPECT_NEAR(negligible_from_mm({0.01, 0.0}, constant, 1.0), 3.841458820694124e-4 / 2.0 / 0.2e-3, 1e-9);
  EXPECT_EQ(negligible_from_mm(offset, none, 1.0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace axiometry::tracking
