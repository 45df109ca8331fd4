// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lines/seven_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/tracking/geometry/obstacles.h"
#include "axiometry/tracking/geometry/visibility.h"
#include "axiometry/tracking/lines/line_attempt.h"

namespace axiometry::tracking {
namespace {

constexpr double same_length_mm = 1e-6;  // intervals this alike count as equal: rounding must not choose the octant
constexpr double farthest_mm = 1e7;      // no machine is longer

bool better(const Attempt& a, const Attempt& b) {
  if (a.stage != b.stage) return a.stage > b.stage;
  return a.interval.length_mm() > b.interval.length_mm() + same_length_mm;
}

std::string components_text(Vector3 v) {
  return fmt::format("({}, {}, {})", format_exact(v.x), format_exact(v.y), format_exact(v.z));
}

Result<void> check_place(std::string_view what, Vector3 place) {
  if (is_finite(place) && norm(place) <= farthest_mm) return {};
  return fail(
      fmt::format("found {} {}, expected finite coordinates within {} mm", what, components_text(place), farthest_mm));
}

Result<void> check_limits(const TrackerLimits& limits) {
  const auto pair = [](std::string_view what, double low, double high, double least, double most) -> Result<void> {
    if (low >= least && low < high && high <= most) return {};
    return fail(fmt::format("found {} {} to {}, expected a lower and then a higher number within {} to {}", what,
                            format_exact(low), format_exact(high), least, most));
  };
  AXIOMETRY_TRY_VOID(pair("a range in mm of", limits.range_least_mm, limits.range_most_mm, 0.0, farthest_mm));
  AXIOMETRY_TRY_VOID(
      pair("an elevation in ° of", limits.elevation_lowest_deg, limits.elevation_highest_deg, -90.0, 90.0));
  if (!(limits.incidence_most_deg > 0.0 && limits.incidence_most_deg <= 180.0))
    return fail(fmt::format("found a largest incidence of {}°, expected 0 to 180", limits.incidence_most_deg));
  if (!is_finite(limits.reflector_axis) || !(norm(limits.reflector_axis) > 0.0))
    return fail(fmt::format("found the axis of the reflector {}, expected a direction",
                            components_text(limits.reflector_axis)));
  for (const auto& [what, x] :
       {std::pair("safe radius", limits.safe_radius_mm), std::pair("least length of a line", limits.line_least_mm)})
    if (!(x >= 0.0 && x <= farthest_mm))
      return fail(fmt::format("found a {} of {} mm, expected 0 to {}", what, format_exact(x), farthest_mm));
  return {};
}

bool has_extent(const BoxObstacle& box) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(box.lowest_mm[k] < box.highest_mm[k])) return false;
  return is_finite(box.lowest_mm) && is_finite(box.highest_mm);
}
bool has_extent(const SphereObstacle& sphere) {
  return is_finite(sphere.centre_mm) && sphere.radius_mm > 0.0 && std::isfinite(sphere.radius_mm);
}
bool has_extent(const CylinderObstacle& cylinder) {
  return is_finite(cylinder.base_mm) && cylinder.radius_mm > 0.0 && std::isfinite(cylinder.radius_mm) &&
         cylinder.height_mm > 0.0 && std::isfinite(cylinder.height_mm);
}

/// Farther than it measures: no line and no other place could be seen from it.
Result<void> check_station_near(const TrackingSetup& setup) {
  const Vector3 station = setup.station.position_mm;
  Vector3 outside;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = setup.travel.lowest_mm[k] + setup.tool_offset_mm[k];
    const double high = setup.travel.highest_mm[k] + setup.tool_offset_mm[k];
    outside[k] = std::max({low - station[k], station[k] - high, 0.0});
  }
  if (norm(outside) <= setup.limits.range_most_mm) return {};
  return fail(fmt::format(
      "found the station at ({}, {}, {}) mm, {} mm from all that the reflector reaches, expected it within the "
      "range of {} mm "
      "(are its coordinates in mm, and in those of the reflector?)",
      format_fixed(station.x, 1), format_fixed(station.y, 1), format_fixed(station.z, 1),
      format_fixed(norm(outside), 0), format_exact(setup.limits.range_most_mm)));
}

}  // namespace

Result<void> check_setup(const TrackingSetup& setup) {
  static constexpr std::string_view axes = "XYZ";
  AXIOMETRY_TRY_VOID(check_place("the tool offset", setup.tool_offset_mm));
  const Vector3 station = setup.station.position_mm;
  const bool none = std::isnan(station.x) && std::isnan(station.y) && std::isnan(station.z);  // no_station()
  if (!none) AXIOMETRY_TRY_VOID(check_place("the station at", station));
  AXIOMETRY_TRY_VOID(check_place("the lower ends of the travels", setup.travel.lowest_mm));
  AXIOMETRY_TRY_VOID(check_place("the upper ends of the travels", setup.travel.highest_mm));
  for (std::size_t k = 0; k < 3; ++k)
    if (!(setup.travel.lowest_mm[k] < setup.travel.highest_mm[k]))
      return fail(fmt::format("found the travel of {} {} to {} mm, expected its lower end and then its higher one",
                              axes[k], format_exact(setup.travel.lowest_mm[k]),
                              format_exact(setup.travel.highest_mm[k])));
  AXIOMETRY_TRY_VOID(check_limits(setup.limits));
  for (const Obstacle& obstacle : setup.obstacles)
    if (!std::visit([](const auto& shape) { return has_extent(shape); }, obstacle.shape))
      return fail(
          fmt::format("found the obstacle \"{}\" without extent, expected lower and then higher ends, and "
                      "radii and heights above 0",
                      obstacle.name));
  if (is_aligned(setup)) return {};
  for (const Obstacle& obstacle : setup.obstacles)
    if (const double beside = distance_to(obstacle, setup.station.position_mm); beside < beam_margin_mm)
      return fail(
          fmt::format("found the station {:.1f} mm from the obstacle \"{}\", expected it {} mm outside at least",
                      beside, obstacle.name, beam_margin_mm));
  return check_station_near(setup);
}

LineChoice choose_lines(const TrackingSetup& setup, std::span<const std::string> ids, DiagonalRule rule) {
  LineChoice choice;
  for (const std::string& id : ids) {
    std::optional<Attempt> best;
    for (const Vector3& direction : line_directions(setup, id, rule)) {
      Attempt attempt = attempt_line(setup, id, direction);
      if (!best || better(attempt, *best)) best = std::move(attempt);
    }
    if (best && best->stage == Stage::usable)
      choice.lines.push_back(std::move(best->interval));
    else if (best)
      choice.lost.push_back({id, std::move(best->reason)});
    else
      choice.lost.push_back({id, "no direction leads from the station to a corner of the travels"});
  }
  return choice;
}

}  // namespace axiometry::tracking
