// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"

namespace axiometry::compensation {

/// Where a table has its positions, as far as the user says; mm or °.
struct GridRequest {
  std::optional<double> start{}, end{}, step{};
  std::optional<std::size_t> points{};
};

/// What the control wants of them.
struct GridLimits {
  std::size_t points = 0;  ///< most; 0: not limited
  bool equidistant = false;
  double step = 0.0;               ///< the only one; 0: any
  std::optional<double> anchor{};  ///< a whole number of steps from the first position
};

/// Positions of a table for targets that were measured, all within them unless the user says otherwise. Without a
/// wish: the targets where the control takes them as they are, else whole multiples of a round step (1, 2, 2.5 or 5
/// with zeros): the largest, at most the median spacing of the targets, that leaves less than a tenth of the spacing
/// beyond the ends of the table, within the control's number of points.
/// Fails on fewer than two targets, an end that is not behind the start, a step that is not above 0 or does not lead
/// from start to end, step and points that contradict each other, and more points than the control takes.
Result<std::vector<double>> grid_of(std::span<const double> targets, const GridRequest& request,
                                    const GridLimits& limits);

}  // namespace axiometry::compensation
