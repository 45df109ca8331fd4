// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/says_nothing.h"

namespace axiometry {
namespace {

constexpr double shortest_direction = 1e-9;

/// Of a direction: far below what any program or instrument tells apart, far above the rounding of doubles.
constexpr double moves_above = 1e-9;

std::optional<Vector3> vector_of(const std::vector<double>& numbers) {
  if (numbers.size() != 3) return std::nullopt;
  const Vector3 v{numbers[0], numbers[1], numbers[2]};
  return is_finite(v) && norm(v) <= largest_stated ? std::optional(v) : std::nullopt;
}

}  // namespace

bool may_be_compensated(const Axis& axis) {
  if (!axis.compensation_points.empty()) return true;
  return !text::says_nothing(axis.compensation) && !text::says_no(axis.compensation);
}

bool states_no_compensation(const Axis& axis) {
  return axis.compensation_points.empty() && text::says_no(axis.compensation);
}

std::optional<SpatialLine> spatial_line(const Axis& axis) {
  const auto origin = vector_of(axis.line_origin_mm), direction = vector_of(axis.line_direction);
  if (axis.kind != AxisKind::linear || !origin || !direction || norm(*direction) < shortest_direction)
    return std::nullopt;
  return SpatialLine{*origin, unit(*direction)};
}

void set_spatial_line(Axis& axis, const SpatialLine& line) {
  const auto& [origin, direction] = line;
  axis.line_origin_mm = {origin.x, origin.y, origin.z};
  axis.line_direction = {direction.x, direction.y, direction.z};
}

std::size_t moving_axes(const SpatialLine& line) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) count += std::abs(line.direction[k]) > moves_above;
  return count;
}

std::optional<double> AxisEnds::length_native() const {
  return lower && upper ? std::optional(upper->in_native() - lower->in_native()) : std::nullopt;
}

AxisEnds axis_ends(const Axis& axis) {
  AxisEnds ends{axis.travel_begin, axis.travel_end};
  if (!ends.lower || !ends.upper || !(*ends.lower > *ends.upper)) return ends;
  constexpr double turn_deg = 360.0;
  if (axis.kind == AxisKind::rotary)  // from 350° on through 0° to 10°
    ends.upper = Position::native(ends.upper->in_native() + turn_deg);
  else
    std::swap(ends.lower, ends.upper);
  return ends;
}

bool is_diagonal(const Axis& axis) {
  const auto line = spatial_line(axis);
  return line && moving_axes(*line) > 1;
}

std::string_view position_unit(AxisKind kind) { return kind == AxisKind::linear ? "mm" : "°"; }

std::string_view deviation_unit(AxisKind kind) { return kind == AxisKind::linear ? "µm" : "″"; }

std::string_view deviation_unit_key(AxisKind kind) { return kind == AxisKind::linear ? "um" : "arcsec"; }

std::string_view axis_kind_name(AxisKind kind) { return kind == AxisKind::linear ? "linear" : "rotary"; }

}  // namespace axiometry
