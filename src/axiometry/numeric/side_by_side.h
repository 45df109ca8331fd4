// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace axiometry::numeric {

/// work(0) to work(count − 1), each once, in turn on so many threads (at least one, this one among them). What is done
/// must not throw, and must not depend on the order.
template <typename Work>
void side_by_side(std::size_t count, std::size_t threads, const Work& work) {
  const std::size_t used = std::clamp(threads, std::size_t{1}, std::max(count, std::size_t{1}));
  const auto run = [&](std::size_t first) {
    for (std::size_t k = first; k < count; k += used) work(k);
  };
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < used; ++k) others.emplace_back(run, k);
  run(0);
}

}  // namespace axiometry::numeric
