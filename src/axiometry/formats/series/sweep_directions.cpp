// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/series/sweep_directions.h"

#include <cstdlib>

namespace axiometry::formats::generic {

Motion motion_of(std::span<const std::uint32_t> ranks, std::size_t target_count) {
  Motion motion;
  const std::size_t n = ranks.size();
  if (n < 2 || target_count < 2) return motion;
  const auto step = [&](std::size_t k) {
    return static_cast<std::int64_t>(ranks[k + 1]) - static_cast<std::int64_t>(ranks[k]);
  };
  const auto whole = static_cast<std::int64_t>(target_count) - 1;
  const auto is_return = [&](std::int64_t s) { return target_count > 2 && std::abs(s) == whole; };
  const auto direction_of = [](std::int64_t s) { return s > 0 ? Direction::up : Direction::down; };
  motion.is_sweeps = true;
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t before = k > 0 ? step(k - 1) : 0;
    const std::int64_t after = k + 1 < n ? step(k) : 0;
    if (std::abs(before) > 1 && !is_return(before)) motion.is_sweeps = false;
    Direction direction;
    if (before != 0 && !is_return(before)) {
      direction = direction_of(before);
    } else if (after != 0 && !is_return(after)) {
      direction = direction_of(after);
      // Two visits in a row are a turn only when the axis comes back; otherwise they tell nothing (step cycle).
      if (k > 0 && before == 0 && direction == motion.directions.back()) motion.is_sweeps = false;
    } else {
      motion.is_sweeps = false;
      direction = Direction::up;
    }
    motion.directions.push_back(direction);
    (direction == Direction::up ? motion.has_up : motion.has_down) = true;
  }
  return motion;
}

}  // namespace axiometry::formats::generic
