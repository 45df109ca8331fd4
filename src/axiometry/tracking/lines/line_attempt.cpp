// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lines/line_attempt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/text/number_text.h"
#include "axiometry/tracking/geometry/line_geometry.h"
#include "axiometry/tracking/geometry/machine_axes.h"
#include "axiometry/tracking/geometry/obstacles.h"
#include "axiometry/tracking/geometry/visibility.h"

namespace axiometry::tracking {
namespace {

constexpr double slack_mm = 1e-9;  // a station on the limit of a travel is in it

std::string octant_of(Vector3 direction) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) text += !axis_moves(direction, k) ? "0" : direction[k] > 0.0 ? "+" : "−";
  return text;
}

struct End {
  double at = 0.0;
  std::string by;
};

/// What is left of a line while one thing after the other cuts it.
struct Piece {
  End begin;
  End end;
  double length() const { return end.at - begin.at; }
};

/// Why the station cannot be on a line that keeps this axis where it is.
std::string outside_text(const TrackingSetup& setup, std::size_t k) {
  const double low = setup.travel.lowest_mm[k] + setup.tool_offset_mm[k];
  const double high = setup.travel.highest_mm[k] + setup.tool_offset_mm[k];
  const double at = setup.station.position_mm[k];
  const double missing = std::max(low - at, at - high);
  if (k == 2 && at < low)
    return fmt::format(
        "sphere below reach: the reflector comes down to Z {} mm only, the station is at Z {} mm: {:.1f} mm "
        "are missing; a tool longer or an instrument higher by that would help",
        format_fixed(low, 1), format_fixed(at, 1), missing);
  return fmt::format(
      "the station at {0} {1} mm is {2:.1f} mm outside the travel of {0}: the reflector reaches {3} to {4} mm",
      axis_names[k], format_fixed(at, 1), missing, format_fixed(low, 1), format_fixed(high, 1));
}

std::optional<std::string> off_travels(const TrackingSetup& setup, Vector3 direction) {
  std::string reasons;
  for (std::size_t k = 0; k < 3; ++k) {
    const double q = setup.station.position_mm[k] - setup.tool_offset_mm[k];
    if (axis_moves(direction, k) ||
        (q >= setup.travel.lowest_mm[k] - slack_mm && q <= setup.travel.highest_mm[k] + slack_mm))
      continue;
    reasons += (reasons.empty() ? "" : "; ") + outside_text(setup, k);
  }
  return reasons.empty() ? std::nullopt : std::optional(reasons);
}

/// Where the axes can follow the line: the slabs of the box, one after the other.
Piece in_travels(const TrackingSetup& setup, Vector3 direction) {
  Piece piece{{0.0, "the station"}, {std::numeric_limits<double>::infinity(), ""}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!axis_moves(direction, k)) continue;
    const double q = setup.station.position_mm[k] - setup.tool_offset_mm[k];
    const bool up = direction[k] > 0.0;
    const double enter = ((up ? setup.travel.lowest_mm[k] : setup.travel.highest_mm[k]) - q) / direction[k];
    const double leave = ((up ? setup.travel.highest_mm[k] : setup.travel.lowest_mm[k]) - q) / direction[k];
    const auto name = [&](bool upper) { return fmt::format("{} end of {}", upper ? "upper" : "lower", axis_names[k]); };
    if (enter > piece.begin.at) piece.begin = {enter, name(!up)};
    if (leave < piece.end.at) piece.end = {leave, name(up)};
  }
  return piece;
}

void begin_after(Piece& piece, double at, std::string_view by) {
  if (at > piece.begin.at) piece.begin = {at, std::string(by)};
}

void end_before(Piece& piece, double at, std::string_view by) {
  if (at < piece.end.at) piece.end = {at, std::string(by)};
}

/// What obstacles leave: the longest piece without one in its way, before the first in the beam.
Piece without_obstacles(const TrackingSetup& setup, Vector3 direction, Piece piece) {
  const Vector3 station = setup.station.position_mm, far = station + piece.end.at * direction;
  const double length = piece.end.at;
  std::vector<Piece> free = {piece};
  for (const Obstacle& obstacle : setup.obstacles) {
    if (length <= 0.0) break;
    const std::string name = obstacle.name.empty() ? "an obstacle" : obstacle.name;
    const auto in_beam = part_nearer_than(obstacle, station, far, beam_margin_mm);
    const auto in_way = part_nearer_than(obstacle, station, far, obstacle_margin_mm);
    std::vector<Piece> left;
    for (const Piece& one : free) {
      if (!in_way) {
        left.push_back(one);
        continue;
      }
      Piece before = one, behind = one;
      end_before(before, in_way->from * length, name + " in the way");
      if (before.length() > 0.0) left.push_back(before);
      begin_after(behind, in_way->to * length, name + " in the way");
      if (!in_beam && behind.length() > 0.0) left.push_back(behind);
    }
    free = std::move(left);
  }
  if (free.empty()) return {{0.0, "an obstacle"}, {0.0, "an obstacle"}};
  return *std::ranges::max_element(free, {}, &Piece::length);
}

std::optional<std::string> too_short(const TrackingSetup& setup, const Piece& piece) {
  if (piece.length() >= setup.limits.line_least_mm - slack_mm && piece.length() > 0.0) return std::nullopt;
  if (piece.length() <= 0.0)
    return fmt::format("nothing of it is left between {} ({:.1f} mm from the station) and {} ({:.1f} mm)",
                       piece.begin.by, piece.begin.at, piece.end.by, piece.end.at);
  return fmt::format(
      "only {:.1f} mm of it are usable, from {} ({:.1f} mm from the station) to {} ({:.1f} mm), expected {:.1f} mm",
      piece.length(), piece.begin.by, piece.begin.at, piece.end.by, piece.end.at, setup.limits.line_least_mm);
}

Attempt refused(Attempt attempt, Stage stage, std::string reason) {
  attempt.stage = stage;
  attempt.reason = std::move(reason);
  return attempt;
}

}  // namespace

double incidence_deg(Vector3 direction, Vector3 reflector_axis) {
  const double length = norm(reflector_axis);
  if (!(length > 0.0)) return 0.0;
  return std::acos(std::clamp(-dot(direction, reflector_axis) / length, -1.0, 1.0)) * deg_per_rad;
}

std::vector<Vector3> line_directions(const TrackingSetup& setup, std::string_view id, DiagonalRule rule) {
  if (std::ranges::find(seven_lines, id) == seven_lines.end()) return {};
  std::vector<Vector3> directions;
  for (unsigned signs = 0; signs < 8; ++signs) {
    Vector3 direction;
    bool exists = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool down = (signs >> k & 1U) != 0;
      const bool moving = id.find("xyz"[k]) != std::string_view::npos;
      if (!moving) {
        exists = exists && !down;
      } else if (rule == DiagonalRule::equal_increments || id.size() == 1) {
        direction[k] = down ? -1.0 : 1.0;
      } else {
        const double corner = (down ? setup.travel.lowest_mm : setup.travel.highest_mm)[k] + setup.tool_offset_mm[k];
        direction[k] = corner - setup.station.position_mm[k];
        exists = exists && (down ? direction[k] < -slack_mm : direction[k] > slack_mm);
      }
    }
    if (exists) directions.push_back(unit(direction));
  }
  return directions;
}

Attempt attempt_line(const TrackingSetup& setup, std::string_view id, Vector3 direction) {
  const TrackerLimits& limits = setup.limits;
  Attempt attempt{.interval = {.id = std::string(id), .direction = direction, .octant = octant_of(direction)}};
  if (auto reason = off_travels(setup, direction)) return refused(attempt, Stage::off_travels, *std::move(reason));
  Piece piece = in_travels(setup, direction);
  if (piece.length() <= 0.0)
    return refused(attempt, Stage::past_travels, "the line from the station leads past the travels");
  const double elevation = std::asin(std::clamp(direction.z, -1.0, 1.0)) * deg_per_rad;
  if (elevation < limits.elevation_lowest_deg - limit_slack_deg ||
      elevation > limits.elevation_highest_deg + limit_slack_deg)
    return refused(
        attempt, Stage::elevation,
        fmt::format("its beam has an elevation of {}°, the instrument takes {}° to {}°", format_fixed(elevation, 1),
                    format_fixed(limits.elevation_lowest_deg, 1), format_fixed(limits.elevation_highest_deg, 1)));
  if (const double incidence = incidence_deg(direction, limits.reflector_axis);
      incidence > limits.incidence_most_deg + limit_slack_deg)
    return refused(attempt, Stage::incidence,
                   fmt::format("its beam comes {:.1f}° off the axis of the reflector, which takes {:.1f}°: turn the "
                               "reflector towards the station",
                               incidence, limits.incidence_most_deg));
  begin_after(piece, limits.safe_radius_mm, "safe radius");
  begin_after(piece, limits.range_least_mm, "least range of the instrument");
  end_before(piece, limits.range_most_mm, "range of the instrument");
  if (!setup.obstacles.empty()) piece = without_obstacles(setup, direction, piece);
  attempt.interval.begin_mm = piece.begin.at;
  attempt.interval.end_mm = piece.end.at;
  attempt.interval.limited_by_begin = piece.begin.by;
  attempt.interval.limited_by_end = piece.end.by;
  if (auto reason = too_short(setup, piece)) return refused(attempt, Stage::too_short, *std::move(reason));
  return attempt;
}

}  // namespace axiometry::tracking
