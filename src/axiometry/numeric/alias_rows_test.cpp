// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/alias_rows.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {
namespace {

/// How much of (0, 1) draws each alternative, from the middles of so many equal parts.
std::vector<double> drawn_shares(const AliasRows& table, std::size_t row, std::size_t alternatives, std::size_t parts) {
  std::vector<double> shares(alternatives);
  for (std::size_t k = 0; k < parts; ++k)
    shares.at(table(row, (double(k) + 0.5) / double(parts))) += 1.0 / double(parts);
  return shares;
}

std::vector<double> any_weights(std::size_t alternatives) {
  std::vector<double> weights(alternatives);
  fill_uniform({5, 1, alternatives}, weights);
  for (double& weight : weights) weight = weight < 0.3 ? 0.0 : weight * weight * weight;
  weights.back() = 0.5;
  return weights;
}

TEST(AliasRows, DrawEveryAlternativeByItsWeight) {
  constexpr std::size_t parts = 1 << 20;
  for (std::size_t alternatives : {1u, 2u, 3u, 7u, 64u, 117u, 255u, 256u}) {
    const std::vector<double> weights = any_weights(alternatives), alike(alternatives, 2.5);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    AliasRows table(3, alternatives);
    table.set(1, weights);
    table.set(2, alike);
    const auto shares = drawn_shares(table, 1, alternatives, parts),
               equal = drawn_shares(table, 2, alternatives, parts);
    for (std::size_t k = 0; k < alternatives; ++k) {
      // A threshold in each part, between two of the middles: as many errors of half a step as there are parts.
      const double slack = double(alternatives + 1) / double(parts);
      ASSERT_NEAR(shares[k], weights[k] / sum, slack) << alternatives << ", " << k;
      ASSERT_NEAR(equal[k], 1.0 / double(alternatives), slack) << alternatives << ", " << k;
      if (weights[k] == 0.0) {
        ASSERT_EQ(shares[k], 0.0) << alternatives << ", " << k;
      }
    }
  }
}

TEST(AliasRows, DrawTheOneThatHasAllTheWeight) {
  for (std::size_t chosen : {0u, 5u, 10u}) {
    std::vector<double> weights(11);
    weights[chosen] = 1e-300;
    AliasRows table(1, weights.size());
    table.set(0, weights);
    for (double u : {0x1p-53, 0.1, 0.5, 10.0 / 11.0, 1.0 - 0x1p-53}) EXPECT_EQ(table(0, u), chosen) << u;
  }
}

TEST(AliasRows, StayWithinTheirAlternativesNextToOne) {
  for (std::size_t alternatives = 1; alternatives <= AliasRows::most_alternatives; ++alternatives) {
    const AliasRows table(1, alternatives);  // of their own alone
    ASSERT_EQ(table(0, 1.0 - 0x1p-53), alternatives - 1);
    ASSERT_EQ(table(0, 0x1p-53), 0u);
  }
}

}  // namespace
}  // namespace axiometry::numeric
