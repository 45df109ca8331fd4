// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"

/// Formula (1) of 5.2, as plan.h explains it. Private to standards/. Numbers in mm or °.
namespace axiometry::iso230_2 {

/// (i − 1)·p with the room that each r has.
struct TargetGrid {
  double first = 0.0;          ///< position of target 1 without its random part
  double interval = 0.0;       ///< p
  std::size_t count = 0;       ///< m
  double shift = 0.0;          ///< R
  double shift_inwards = 0.0;  ///< shift of the first and the last; both shift as the others do when without_end
  bool without_end = false;
  double step = 0.0;  ///< step to which targets are rounded
  bool principal_positions = false;
  double segment = 0.0;  ///< length of a segment of the scale, counted from segments_from; 0 for none
  double segments_from = 0.0;

  double at(std::size_t i) const { return first + static_cast<double>(i) * interval; }
  double last() const { return at(count - 1); }
};

/// Strictly ascending. `stream` parts the tests of one plan. Fails when the step is too coarse for the interval.
Result<std::vector<Position>> draw_targets(const TargetGrid& grid, std::span<const double> compensation_points,
                                           std::uint64_t seed, std::uint64_t stream);

}  // namespace axiometry::iso230_2
