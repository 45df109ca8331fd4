// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/report/drawing/figure.h"

namespace axiometry::report::plot {

/// A curve of more points than a page can show, with as many as it can: of the points within each column of 0.4 pt, a
/// third of the thickness of the line of means, the lowest and the highest, and the first and the last of all.
/// Everywhere within half a column of where it was; extremes stay at their height. Curves of up to 1500 points stay as
/// they are.
///
/// Contract: x does not fall.
std::vector<Point> thinned(std::vector<Point> curve);

/// Beyond as many targets marks at each would be one broad line.
inline constexpr std::size_t most_points_shown = 1500;

}  // namespace axiometry::report::plot
