// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lines/line_order.h"

#include <algorithm>
#include <limits>

namespace axiometry::tracking {
namespace {

constexpr std::size_t most_exact = 12;  // 4096 subsets of 12 × 12 steps
constexpr double no_way_yet = std::numeric_limits<double>::infinity();

/// least[set][last]: the cheapest way over just this set that ends at `last`.
std::vector<std::size_t> exact_order(const std::vector<std::vector<double>>& costs) {
  const std::size_t n = costs.size(), sets = std::size_t{1} << n;
  std::vector<std::vector<double>> least(sets, std::vector<double>(n, no_way_yet));
  std::vector<std::vector<std::size_t>> before(sets, std::vector<std::size_t>(n, n));
  for (std::size_t k = 0; k < n; ++k) least[std::size_t{1} << k][k] = 0.0;
  for (std::size_t set = 1; set < sets; ++set)
    for (std::size_t last = 0; last < n; ++last) {
      if (least[set][last] == no_way_yet) continue;
      for (std::size_t next = 0; next < n; ++next) {
        const std::size_t grown = set | std::size_t{1} << next;
        const double cost = least[set][last] + costs[last][next];
        if (grown == set || cost >= least[grown][next]) continue;
        least[grown][next] = cost;
        before[grown][next] = last;
      }
    }
  std::vector<std::size_t> order;
  std::size_t set = sets - 1;
  std::size_t last = static_cast<std::size_t>(std::ranges::min_element(least[set]) - least[set].begin());
  while (order.size() < n) {
    order.push_back(last);
    const std::size_t previous = before[set][last];
    set &= ~(std::size_t{1} << last);
    last = previous;
  }
  std::ranges::reverse(order);
  return order;
}

std::vector<std::size_t> nearest_first(const std::vector<std::vector<double>>& costs) {
  std::vector<std::size_t> order = {0};
  std::vector<char> taken(costs.size(), 0);
  taken[0] = 1;
  while (order.size() < costs.size()) {
    std::size_t best = costs.size();
    for (std::size_t k = 0; k < costs.size(); ++k)
      if (taken[k] == 0 && (best == costs.size() || costs[order.back()][k] < costs[order.back()][best])) best = k;
    taken[best] = 1;
    order.push_back(best);
  }
  return order;
}

}  // namespace

std::vector<std::size_t> shortest_order(const std::vector<std::vector<double>>& costs) {
  if (costs.empty()) return {};
  return costs.size() <= most_exact ? exact_order(costs) : nearest_first(costs);
}

}  // namespace axiometry::tracking
