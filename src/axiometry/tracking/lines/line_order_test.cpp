// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lines/line_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace axiometry::tracking {
namespace {

double cost_of(const std::vector<std::size_t>& order, const std::vector<std::vector<double>>& costs) {
  double sum = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) sum += costs[order[k - 1]][order[k]];
  return sum;
}

std::vector<std::vector<double>> random_costs(std::size_t n, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<std::vector<double>> costs(n, std::vector<double>(n));
  for (auto& row : costs)
    for (double& x : row) x = static_cast<double>(engine() % 1000);
  return costs;
}

TEST(LineOrder, NoPermutationIsShorter) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto costs = random_costs(6, seed);
    const double found = cost_of(shortest_order(costs), costs);
    std::vector<std::size_t> order(6);
    std::iota(order.begin(), order.end(), 0u);
    do EXPECT_LE(found, cost_of(order, costs));
    while (std::ranges::next_permutation(order).found);
  }
}

TEST(LineOrder, EachLineIsDrivenOnce) {
  for (std::size_t n : {0u, 1u, 2u, 12u, 17u}) {
    auto order = shortest_order(random_costs(n, 5));
    std::ranges::sort(order);
    std::vector<std::size_t> expected(n);
    std::iota(expected.begin(), expected.end(), 0u);
    EXPECT_EQ(order, expected);
  }
}

}  // namespace
}  // namespace axiometry::tracking
