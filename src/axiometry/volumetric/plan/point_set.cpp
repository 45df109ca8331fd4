// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/plan/point_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiometry::volumetric {
namespace {

constexpr double g = 1.2207440846057596;
constexpr std::size_t rounds_most = 60;

double rounded(double mm) { return std::round(mm * 1000.0) / 1000.0; }

}  // namespace

std::vector<Vector3> spread_points(const TravelBox& travel, std::size_t count, Vector3 shift) {
  const Vector3 alpha = {1.0 / g, 1.0 / (g * g), 1.0 / (g * g * g)};
  std::vector<Vector3> points;
  for (std::size_t k = 1; k <= count; ++k) {
    Vector3 q;
    for (std::size_t a = 0; a < 3; ++a) {
      const double along = shift[a] + static_cast<double>(k) * alpha[a];
      const double lowest = travel.lowest_mm[a], highest = travel.highest_mm[a];
      q[a] = std::clamp(rounded(lowest + (along - std::floor(along)) * (highest - lowest)), lowest, highest);
    }
    points.push_back(q);
  }
  return points;
}

std::vector<Vector3> short_tour(std::vector<Vector3> places) {
  const std::size_t n = places.size();
  for (std::size_t i = 0; i + 2 < n; ++i) {
    std::size_t nearest = i + 1;
    for (std::size_t k = i + 2; k < n; ++k)
      if (distance(places[i], places[k]) < distance(places[i], places[nearest])) nearest = k;
    std::swap(places[i + 1], places[nearest]);
  }
  for (std::size_t round = 0; round < rounds_most; ++round) {
    bool gains = false;
    for (std::size_t i = 0; i + 2 < n; ++i)
      for (std::size_t k = i + 2; k < n; ++k) {
        const double now = distance(places[i], places[i + 1]) + (k + 1 < n ? distance(places[k], places[k + 1]) : 0.0);
        const double then = distance(places[i], places[k]) + (k + 1 < n ? distance(places[i + 1], places[k + 1]) : 0.0);
        if (then >= now - 1e-9) continue;
        std::reverse(places.begin() + static_cast<std::ptrdiff_t>(i + 1),
                     places.begin() + static_cast<std::ptrdiff_t>(k + 1));
        gains = true;
      }
    if (!gains) break;
  }
  return places;
}

}  // namespace axiometry::volumetric
