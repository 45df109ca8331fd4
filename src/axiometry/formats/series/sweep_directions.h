// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "axiometry/model/series.h"

namespace axiometry::formats::generic {

/// Directions of approach as the order of the targets tells them, in a file whose rows stand in the order of the
/// measurement.
struct Motion {
  /// Whether the order is that of sweeps along the axis: from each target to its neighbour, from the last one back to
  /// itself (the turn lies beyond it) or in one step to the other end. Otherwise the directions mean nothing.
  bool is_sweeps = false;
  bool has_up = false;
  bool has_down = false;
  std::vector<Direction> directions;  ///< a direction for each row
};

/// `ranks`: for every row the number of its target in ascending order, from 0. The direction of a row is that of the
/// step towards it; where a sweep begins (first row, turn, return in one step) that of the step away from it.
Motion motion_of(std::span<const std::uint32_t> ranks, std::size_t target_count);

}  // namespace axiometry::formats::generic
