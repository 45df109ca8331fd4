// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/series/fourier.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {
namespace {

using Complexes = std::vector<std::complex<double>>;

/// Validation: the definition.
TEST(FourierTransform, IsTheSumThatItStandsFor) {
  for (std::size_t n : {1u, 2u, 8u, 64u}) {
    std::vector<double> z(2 * n);
    fill_normal({2, 0, n}, z);
    Complexes values(n);
    for (std::size_t k = 0; k < n; ++k) values[k] = {z[2 * k], z[2 * k + 1]};
    Complexes transformed = values;
    FourierTransform{n}(transformed);
    for (std::size_t k = 0; k < n; ++k) {
      std::complex<double> sum;
      for (std::size_t m = 0; m < n; ++m)
        sum += values[m] * std::polar(1.0, 2.0 * std::numbers::pi * double(k * m % n) / double(n));
      EXPECT_LT(std::abs(transformed[k] - sum), 1e-13) << n;
    }
  }
}

/// Validation: the sums one by one; places on both sides of zero, few frequencies and as many as are taken at once.
TEST(FourierSums, AreTheSumsOneByOne) {
  constexpr std::size_t n = 50;
  std::vector<double> places(n), ones(n, 1.0), others(n);
  fill_normal({2, 1, 0}, places);
  fill_normal({2, 2, 0}, others);
  for (double& x : places) x *= 300.0;
  const std::array<std::span<const double>, 2> weights = {ones, others};
  FourierSums sums_of(places, weights);
  for (const FrequencyGrid grid : {FrequencyGrid{0.001, 0.0002, 1}, FrequencyGrid{0.001, 0.0002, 777},
                                   FrequencyGrid{-0.3, 0.00001, 8192}, FrequencyGrid{0.5, 0.013, 8191}}) {
    const auto sums = sums_of(grid);
    for (std::size_t r = 0; r < 2; ++r) {
      ASSERT_EQ(sums[r].size(), grid.count);
      double size = 0.0;
      for (double w : weights[r]) size += std::abs(w);
      for (std::size_t k = 0; k < grid.count; k += 1 + grid.count / 500) {
        const double f = grid.first + grid.step * double(k);
        std::complex<double> sum;
        for (std::size_t j = 0; j < n; ++j)
          sum += weights[r][j] * std::polar(1.0, 2.0 * std::numbers::pi * f * places[j]);
        // Of both sums the angles have three roundings of 2⁻⁵³ each.
        const double angle = 2.0 * std::numbers::pi * 900.0 * (std::abs(f) + grid.step * double(grid.count));
        EXPECT_LT(std::abs(sums[r][k] - sum), (1e-13 + 7e-16 * angle) * size) << k;
      }
    }
  }
}

TEST(FourierSums, OfNoFrequenciesAreNone) {
  const std::vector<double> one = {1.0};
  const std::array<std::span<const double>, 1> weights = {one};
  EXPECT_TRUE(FourierSums(one, weights)({1.0, 1.0, 0}).front().empty());
}

}  // namespace
}  // namespace axiometry::numeric
