// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/crowd.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/thinned.h"

namespace axiometry::report::plot {
namespace {

constexpr double least_width = 6.0;
constexpr std::size_t fewest_of_a_band = 40;  // of fewer 2.5 % are no point at either side
constexpr double beyond_each_side = 0.025;
const Stroke crowd_median = ink::solid(ink::black, 0.8);  // pen of the medians

/// Sorts them by y.
void add_band(Crowd& result, std::span<Point> points, double left, double right) {
  std::ranges::sort(points, {}, &Point::y);
  const auto beyond = static_cast<std::size_t>(beyond_each_side * static_cast<double>(points.size()));
  const std::size_t last = points.size() - 1;
  result.stretches.push_back({.left = left,
                              .right = right,
                              .high = points[beyond].y,
                              .median = (points[last / 2].y + points[points.size() / 2].y) / 2.0,
                              .low = points[last - beyond].y});
  if (points.front().y < points[beyond].y) result.dots.push_back(points.front());
  if (points.back().y > points[last - beyond].y) result.dots.push_back(points.back());
}

}  // namespace

Crowd crowd(std::vector<Point> points) {
  if (points.size() <= most_points_shown) return {.dots = std::move(points), .stretches = {}};
  std::ranges::sort(points, {}, &Point::x);
  const double left = points.front().x, extent = points.back().x - left;
  const double wanted = std::max(least_width, extent * double(fewest_of_a_band) / static_cast<double>(points.size()));
  const double count = std::max(1.0, std::floor(extent / wanted));  // of at most n/40 stretches one has 40 points
  const double width = std::max(extent / count, wanted);
  const auto stretch_of = [&](std::size_t k) {
    return std::min(std::floor((points[k].x - left) / width), count - 1.0);
  };
  Crowd result;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && stretch_of(end) == stretch_of(begin)) ++end;
    const std::span<Point> here(points.data() + begin, end - begin);
    const double edge = left + width * stretch_of(begin);
    if (here.size() < fewest_of_a_band)
      result.dots.insert(result.dots.end(), here.begin(), here.end());
    else
      add_band(result, here, edge, edge + width);
  }
  return result;
}

std::vector<Point> apart(const std::vector<Point>& points, double radius) {
  std::set<std::pair<double, double>> taken;
  std::vector<Point> kept;
  for (const Point& p : points)
    if (taken.emplace(std::floor(p.x / radius), std::floor(p.y / radius)).second) kept.push_back(p);
  return kept;
}

LegendEntry crowd_entry(Colour band, Runs words) {
  return {.line = crowd_median, .band = band, .mark = std::nullopt, .text = std::move(words)};
}

void draw_stretches(std::vector<Operation>& operations, const std::vector<CrowdStretch>& stretches, Colour band) {
  for (std::size_t begin = 0, end = 0; begin < stretches.size(); begin = end) {
    for (end = begin + 1; end < stretches.size() && stretches[end].left - stretches[end - 1].right < 1e-6;) ++end;
    Path outline{.points = {}, .closed = true, .stroke = {.width = 0.0}, .fill = band};
    Path middle{.points = {}, .closed = false, .stroke = crowd_median, .fill = {0, 0, 0, 0}};
    for (std::size_t k = begin; k < end; ++k) {
      const CrowdStretch& s = stretches[k];
      outline.points.insert(outline.points.end(), {{s.left, s.high}, {s.right, s.high}});
      middle.points.insert(middle.points.end(), {{s.left, s.median}, {s.right, s.median}});
    }
    for (std::size_t k = end; k-- > begin;)
      outline.points.insert(outline.points.end(),
                            {{stretches[k].right, stretches[k].low}, {stretches[k].left, stretches[k].low}});
    operations.push_back(std::move(outline));
    operations.push_back(std::move(middle));
  }
}

}  // namespace axiometry::report::plot
