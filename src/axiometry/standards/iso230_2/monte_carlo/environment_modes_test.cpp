// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/environment_modes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/numeric/random/random.h"

namespace axiometry {
namespace {

std::vector<double> equal_steps(std::size_t count) {
  std::vector<double> shares(count);
  for (std::size_t k = 0; k < count; ++k) shares[k] = double(k) / double(count - 1);
  return shares;
}

/// Mean square range of many draws.
double root_mean_square_range(const EnvironmentModes& modes) {
  constexpr std::size_t draws = 4000;
  double squares = 0.0;
  std::vector<double> c(modes.count());
  for (std::size_t d = 0; d < draws; ++d) {
    numeric::fill_normal({1, 0, d}, c);
    double low = 0.0, high = 0.0;
    for (std::size_t r = 0; r < modes.places; ++r) {
      double e = 0.0;
      for (std::size_t k = 0; k < modes.count(); ++k) e += c[k] * modes.mode(k)[r];
      low = r == 0 ? e : std::min(low, e);
      high = r == 0 ? e : std::max(high, e);
    }
    squares += (high - low) * (high - low) / draws;
  }
  return std::sqrt(squares);
}

TEST(EnvironmentModes, HaveTheStatedRangeOverTheTest) {
  const auto shares = equal_steps(100);
  // Of Brownian motion with the mean range 1 a hundred readings see 0.93 (2 · 0.583/√100 of σ less).
  EXPECT_NEAR(root_mean_square_range(environment_modes(EnvironmentKind::random_walk, shares, 5)), 0.93, 0.04);
  // Swings of several frequencies together have a somewhat larger range than the root of the sum of their squares.
  EXPECT_NEAR(root_mean_square_range(environment_modes(EnvironmentKind::drift, shares, 5)), 1.15, 0.25);
}

TEST(EnvironmentModes, AreNothingWhereAReadingHasNoTime) {
  auto shares = equal_steps(10);
  shares[3] = std::numeric_limits<double>::quiet_NaN();
  for (EnvironmentKind kind : {EnvironmentKind::drift, EnvironmentKind::random_walk}) {
    const auto modes = environment_modes(kind, shares, 3);
    for (std::size_t k = 0; k < modes.count(); ++k) EXPECT_EQ(modes.mode(k)[3], 0.0);
  }
}

TEST(EnvironmentModes, OfACovarianceGiveItBack) {
  std::vector<double> covariance;
  for (int lag = 0; lag <= 40; ++lag) covariance.push_back(std::exp(-0.5 * std::pow(lag / 12.0, 2)));
  const auto modes = modes_of_covariance(covariance, equal_steps(41));
  for (std::size_t i : {0u, 7u, 40u})
    for (std::size_t j : {0u, 12u, 30u}) {
      double sum = 0.0;
      for (std::size_t k = 0; k < modes.count(); ++k) sum += modes.mode(k)[i] * modes.mode(k)[j];
      EXPECT_NEAR(sum, covariance[i > j ? i - j : j - i], 0.02) << i << " " << j;
    }
}

}  // namespace
}  // namespace axiometry
