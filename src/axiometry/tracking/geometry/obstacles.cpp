// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/geometry/obstacles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiometry::tracking {
namespace {

constexpr int section_steps = 64;   // 0.618⁶⁴ = 4e-14 of the segment
constexpr int triangle_steps = 44;  // 0.618⁴⁴ = 6e-10 of its sides; squared in number of evaluations
constexpr int bisection_steps = 60;

double distance_to_shape(const BoxObstacle& box, Vector3 p) {
  Vector3 outside;
  for (std::size_t k = 0; k < 3; ++k) outside[k] = std::max({box.lowest_mm[k] - p[k], p[k] - box.highest_mm[k], 0.0});
  return norm(outside);
}

double distance_to_shape(const SphereObstacle& sphere, Vector3 p) {
  return std::max(distance(p, sphere.centre_mm) - sphere.radius_mm, 0.0);
}

double distance_to_shape(const CylinderObstacle& cylinder, Vector3 p) {
  const Vector3 r = p - cylinder.base_mm;
  const double beside = std::max(std::hypot(r.x, r.y) - cylinder.radius_mm, 0.0);
  const double beyond = std::max({-r.z, r.z - cylinder.height_mm, 0.0});
  return std::hypot(beside, beyond);
}

struct Least {
  double at = 0.0;
  double value = 0.0;
};

/// Of a convex function over [0, high], by golden section. A level part is the least already.
template <typename Function>
Least least_of(const Function& f, double high, int steps) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.0;
  Least best{0.0, f(0.0)};
  const auto look = [&](double at) {
    const double value = f(at);
    if (value < best.value) best = {at, value};
    return value;
  };
  look(high);
  double left = high - golden * high, right = golden * high;
  double at_left = look(left), at_right = look(right);
  for (int k = 0; k < steps && best.value > 0.0; ++k)
    if (at_left <= at_right) {
      high = std::exchange(right, left);
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = look(left);
    } else {
      low = std::exchange(left, right);
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = look(right);
    }
  return best;
}

/// Where f crosses the limit between `near`, where it is below, and `far`, where it is not.
template <typename Function>
double crossing(const Function& f, double near, double far, double limit) {
  for (int k = 0; k < bisection_steps; ++k) {
    const double middle = 0.5 * (near + far);
    (f(middle) < limit ? near : far) = middle;
  }
  return far;
}

}  // namespace

double distance_to(const Obstacle& obstacle, Vector3 point_mm) {
  return std::visit([&](const auto& shape) { return distance_to_shape(shape, point_mm); }, obstacle.shape);
}

double distance_to(const Obstacle& obstacle, Vector3 a_mm, Vector3 b_mm) {
  return least_of([&](double t) { return distance_to(obstacle, a_mm + t * (b_mm - a_mm)); }, 1.0, section_steps).value;
}

double distance_to(const Obstacle& obstacle, Vector3 station_mm, Vector3 a_mm, Vector3 b_mm) {
  // Convex in both coordinates together, and therefore in the first one after the least over the second.
  const auto across = [&](double along) {
    const Vector3 from = station_mm + along * (a_mm - station_mm);
    return least_of([&](double t) { return distance_to(obstacle, from + t * (b_mm - a_mm)); }, along, triangle_steps)
        .value;
  };
  return least_of(across, 1.0, triangle_steps).value;
}

std::optional<SegmentPart> part_nearer_than(const Obstacle& obstacle, Vector3 a_mm, Vector3 b_mm, double margin_mm) {
  const auto at = [&](double t) { return distance_to(obstacle, a_mm + t * (b_mm - a_mm)); };
  const Least least = least_of(at, 1.0, section_steps);
  if (least.value > 0.0 && least.value >= margin_mm) return std::nullopt;
  const double limit = std::max(margin_mm, 1e-12);
  return SegmentPart{at(0.0) < limit ? 0.0 : crossing(at, least.at, 0.0, limit),
                     at(1.0) < limit ? 1.0 : crossing(at, least.at, 1.0, limit)};
}

}  // namespace axiometry::tracking
