// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/axis.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/text.h"

namespace axiometry {
namespace {

constexpr double shortest_direction = 1e-9;
constexpr double farthest = 1e9;

/// Of a direction: far below what any program or instrument tells apart, far above the rounding of doubles.
constexpr double moves_above = 1e-9;

std::optional<Vector3> vector_of(const std::vector<double>& numbers) {
  if (numbers.size() != 3) return std::nullopt;
  const Vector3 v{numbers[0], numbers[1], numbers[2]};
  return is_finite(v) && norm(v) <= farthest ? std::optional(v) : std::nullopt;
}

/// What is written where there was no compensation, or where nobody says whether there was one.
constexpr std::string_view no_compensation[] = {"none",         "no",
                                                "off",          "not used",
                                                "not active",   "inactive",
                                                "disabled",     "switched off",
                                                "without",      "n/a",
                                                "na",           "unknown",
                                                "not known",    "not stated",
                                                "tbd",          "keine",
                                                "kein",         "nein",
                                                "aus",          "inaktiv",
                                                "nicht aktiv",  "ausgeschaltet",
                                                "abgeschaltet", "ohne",
                                                "unbekannt",    "nicht angegeben",
                                                "aucune",       "aucun",
                                                "non",          "sans",
                                                "désactivée",   "inconnue",
                                                "non indiqué"};

bool has_letter_or_digit(std::string_view text) {
  return std::ranges::any_of(
      text, [](unsigned char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
}

}  // namespace

bool may_be_compensated(const Axis& axis) {
  if (!axis.compensation_points.empty()) return true;
  const std::string_view word = text::trim(axis.compensation);
  return has_letter_or_digit(word) && !text::is_one_of(word, no_compensation);
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

bool is_diagonal(const Axis& axis) {
  const auto line = spatial_line(axis);
  return line && moving_axes(*line) > 1;
}

std::string_view position_unit(AxisKind kind) { return kind == AxisKind::linear ? "mm" : "°"; }

std::string_view deviation_unit(AxisKind kind) { return kind == AxisKind::linear ? "µm" : "″"; }

std::string_view deviation_unit_key(AxisKind kind) { return kind == AxisKind::linear ? "um" : "arcsec"; }

std::string_view axis_kind_name(AxisKind kind) { return kind == AxisKind::linear ? "linear" : "rotary"; }

}  // namespace axiometry
