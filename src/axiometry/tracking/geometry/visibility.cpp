// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/geometry/visibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/tracking/geometry/line_geometry.h"
#include "axiometry/tracking/geometry/obstacles.h"

namespace axiometry::tracking {
namespace {

constexpr double same_place_mm = 1e-9;

double angle_deg(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * deg_per_rad; }

/// Least and largest cosine between a direction of length 1 and r(τ) = a + τ(b − a), which is not 0. Its derivative is
/// 0 at one τ at most, because the squares of τ in it cancel.
struct Cosines {
  double least = 0.0;
  double largest = 0.0;
};
Cosines cosines(Vector3 direction, Vector3 a, Vector3 b) {
  const Vector3 d = b - a;
  const auto at = [&](double t) {
    const Vector3 r = a + t * d;
    return dot(direction, r) / norm(r);
  };
  Cosines found{std::min(at(0.0), at(1.0)), std::max(at(0.0), at(1.0))};
  const double A = dot(direction, a), B = dot(direction, d), C = dot(a, a), D = dot(a, d), E = dot(d, d);
  const double denominator = B * D - A * E;
  if (denominator == 0.0) return found;
  const double stationary = (A * D - B * C) / denominator;
  if (!(stationary > 0.0 && stationary < 1.0)) return found;
  return {std::min(found.least, at(stationary)), std::max(found.largest, at(stationary))};
}

std::optional<std::string> out_of_range(const TrackerLimits& limits, double nearest, double farthest) {
  if (nearest < limits.range_least_mm - limit_slack_mm)
    return fmt::format("{:.1f} mm from the station, nearer than the least range of {:.1f} mm", nearest,
                       limits.range_least_mm);
  if (farthest > limits.range_most_mm + limit_slack_mm)
    return fmt::format("{:.1f} mm from the station, farther than the range of {:.1f} mm", farthest,
                       limits.range_most_mm);
  return std::nullopt;
}

/// Neither range nor obstacles; of a way from a to b as seen from the station.
std::optional<std::string> out_of_sight(const TrackerLimits& limits, Vector3 a, Vector3 b) {
  const Cosines up = cosines({0.0, 0.0, 1.0}, a, b);
  const double lowest = 90.0 - angle_deg(up.least), highest = 90.0 - angle_deg(up.largest);
  if (lowest < limits.elevation_lowest_deg - limit_slack_deg)
    return fmt::format("the beam at an elevation of {}°, below the lowest of {}°", format_fixed(lowest, 1),
                       format_fixed(limits.elevation_lowest_deg, 1));
  if (highest > limits.elevation_highest_deg + limit_slack_deg)
    return fmt::format("the beam at an elevation of {}°, above the highest of {}°", format_fixed(highest, 1),
                       format_fixed(limits.elevation_highest_deg, 1));
  const double length = norm(limits.reflector_axis);
  if (!(length > 0.0)) return std::nullopt;
  const double incidence = angle_deg(cosines(-1.0 / length * limits.reflector_axis, a, b).least);
  if (incidence > limits.incidence_most_deg + limit_slack_deg)
    return fmt::format("the beam {:.1f}° off the axis of the reflector, which takes {:.1f}°", incidence,
                       limits.incidence_most_deg);
  return std::nullopt;
}

std::string in_the_beam(const Obstacle& obstacle) {
  return fmt::format("{} in the beam", obstacle.name.empty() ? "an obstacle" : obstacle.name);
}

}  // namespace

double distance_to_segment(Vector3 point_mm, Vector3 a_mm, Vector3 b_mm) {
  const Vector3 d = b_mm - a_mm;
  const double square = dot(d, d);
  if (square == 0.0) return distance(point_mm, a_mm);
  const double t = std::clamp(dot(point_mm - a_mm, d) / square, 0.0, 1.0);
  return distance(point_mm, a_mm + t * d);
}

bool meets(const Obstacle& obstacle, Vector3 a_mm, Vector3 b_mm, double margin_mm) {
  const double found = distance_to(obstacle, a_mm, b_mm);
  return found == 0.0 || found < margin_mm;
}

std::optional<std::string> hidden_because(const TrackingSetup& setup, Vector3 reflector_mm) {
  return beam_lost_because(setup, reflector_mm, reflector_mm);
}

std::optional<std::string> beam_lost_because(const TrackingSetup& setup, Vector3 from_mm, Vector3 to_mm) {
  if (is_aligned(setup)) return std::nullopt;  // nobody knows where it stands; its beam lies in the line
  const Vector3 station = setup.station.position_mm;
  const double nearest = distance_to_segment(station, from_mm, to_mm);
  if (!is_finite(from_mm) || !is_finite(to_mm)) return "a place that is not finite";
  if (nearest < same_place_mm) return "at the station itself";
  if (auto range = out_of_range(setup.limits, nearest, std::max(distance(station, from_mm), distance(station, to_mm))))
    return range;
  if (auto sight = out_of_sight(setup.limits, from_mm - station, to_mm - station)) return sight;
  for (const Obstacle& obstacle : setup.obstacles) {
    const double found =
        from_mm == to_mm ? distance_to(obstacle, station, from_mm) : distance_to(obstacle, station, from_mm, to_mm);
    if (found < beam_margin_mm - limit_slack_mm) return in_the_beam(obstacle);
  }
  return std::nullopt;
}

std::optional<std::string> blocked_because(const TrackingSetup& setup, Vector3 from_mm, Vector3 to_mm) {
  static constexpr std::array axes = {'X', 'Y', 'Z'};
  for (const Vector3& at : {from_mm, to_mm}) {
    if (!is_finite(at)) return "a place that is not finite";
    for (std::size_t k = 0; k < 3; ++k) {
      const double q = at[k] - setup.tool_offset_mm[k];
      const double low = setup.travel.lowest_mm[k], high = setup.travel.highest_mm[k];
      if (q < low - limit_slack_mm || q > high + limit_slack_mm)
        return fmt::format("{} at {} mm, beyond its travel {} to {} mm", axes[k], format_fixed(q, 3),
                           format_fixed(low, 3), format_fixed(high, 3));
    }
  }
  const double near = distance_to_segment(setup.station.position_mm, from_mm, to_mm);
  if (!is_aligned(setup) && near < setup.limits.safe_radius_mm - limit_slack_mm)
    return fmt::format("{:.1f} mm from the station, within its safe radius of {:.1f} mm", near,
                       setup.limits.safe_radius_mm);
  for (const Obstacle& obstacle : setup.obstacles)
    if (meets(obstacle, from_mm, to_mm, obstacle_margin_mm - limit_slack_mm))
      return fmt::format("{:.1f} mm from {}, nearer than {:.1f} mm", distance_to(obstacle, from_mm, to_mm),
                         obstacle.name.empty() ? "an obstacle" : obstacle.name, obstacle_margin_mm);
  return std::nullopt;
}

}  // namespace axiometry::tracking
