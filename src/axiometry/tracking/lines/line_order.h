// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

/// In which order to drive lines. Private to tracking/.
namespace axiometry::tracking {

/// The order of 0 … n − 1 with the least sum of costs[from][to], the first one free: exact up to 12 (dynamic
/// programming over subsets), else always to the nearest of those left. The first of orders with the same cost.
std::vector<std::size_t> shortest_order(const std::vector<std::vector<double>>& costs);

}  // namespace axiometry::tracking
