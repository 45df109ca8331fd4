// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/figures/parts/legend.h"

namespace axiometry::report::plot {

/// What stands for the points of one upright stretch of a diagram where they are too many to be told apart: its edges,
/// and the y on paper between which the central 95 % of them lie, with their median.
struct CrowdStretch {
  double left = 0.0, right = 0.0;
  double high = 0.0, median = 0.0, low = 0.0;  ///< on paper, so that high ≤ median ≤ low
};

/// Points of a diagram, each for itself or by what stands for a stretch of them.
struct Crowd {
  std::vector<Point>
      dots;  ///< all of a stretch that has few; of one that has many those that lie farthest, up and down
  std::vector<CrowdStretch> stretches;  ///< from left to right
};

/// Up to 1500 points stay as they are. Of more, stretches of 6 pt, or of as much as holds 40 points of evenly spread
/// ones, become a band where they have 40 at least, which one of them has: what is shown is where the points are, and
/// not only how far the farthest of them go, and its size does not grow with their number.
Crowd crowd(std::vector<Point> points);

/// Of points that would lie upon one another, which a disc of this radius cannot show apart, one for each place.
std::vector<Point> apart(const std::vector<Point>& points, double radius);

/// Bands with their medians, as steps.
void draw_stretches(std::vector<Operation>& operations, const std::vector<CrowdStretch>& stretches, Colour band);

/// What a legend says of bands of that colour.
LegendEntry crowd_entry(Colour band, Runs words);
inline constexpr const char* crowd_words = "of many readings the central 95 % with their median, and the farthest";

}  // namespace axiometry::report::plot
