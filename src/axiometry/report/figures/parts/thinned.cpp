// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/thinned.h"

#include <algorithm>
#include <cmath>

namespace axiometry::report::plot {
namespace {
constexpr double column_width = 0.4;
}

std::vector<Point> thinned(std::vector<Point> curve) {
  if (curve.size() <= most_points_shown) return curve;
  const auto column_of = [&](std::size_t k) { return std::floor((curve[k].x - curve.front().x) / column_width); };
  std::vector<Point> kept = {curve.front()};
  for (std::size_t begin = 0, end = 0; begin < curve.size(); begin = end) {
    std::size_t lowest = begin, highest = begin;
    for (end = begin; end < curve.size() && column_of(end) == column_of(begin); ++end) {
      if (curve[end].y < curve[lowest].y) lowest = end;
      if (curve[end].y > curve[highest].y) highest = end;
    }
    const auto [first, second] = std::minmax(lowest, highest);
    if (first != 0) kept.push_back(curve[first]);
    if (second != first) kept.push_back(curve[second]);
    if (end == curve.size() && second + 1 < end) kept.push_back(curve.back());
  }
  return kept;
}

}  // namespace axiometry::report::plot
