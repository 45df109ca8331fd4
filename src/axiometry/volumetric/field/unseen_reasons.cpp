// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/unseen_reasons.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/volumetric/field/point_spread.h"
#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::volumetric {
namespace {

constexpr std::size_t stations_least = 3;
constexpr double stations_apart_mm = 10.0;
constexpr double lever_share_least = 1.0 / 20.0;

/// Where offsets were moved, by so much: "0.03". Nothing below what is printed.
std::optional<std::string> moved_text(std::span<const Vector3> offsets) {
  constexpr double printed_mm = 0.005;
  const std::vector<Vector3> seen = seen_offsets({offsets.begin(), offsets.end()});
  double most = 0.0;
  for (std::size_t k = 0; k < seen.size(); ++k) most = std::max(most, distance(seen[k], offsets[k]));
  if (most < printed_mm) return std::nullopt;
  return fmt::format("{:.2f}", most);
}

std::string one_tool_point(const std::optional<std::string>& moved) {
  std::string first = "all lengths have the same tool point, so that";
  if (moved)
    first = fmt::format("all tool points lie within {} mm of one, and were taken to lie there, so that", *moved);
  return first +
         " a rotation of an axis that nothing but the tool lies behind cannot be told from its straightness; three "
         "tools whose points form a triangle tell all (a short and a long one, and one beside them)";
}

std::string one_tool_line(const std::optional<std::string>& moved) {
  std::string first = "all tool points lie on one line, and";
  if (moved) first = fmt::format("all tool points lie within {} mm of one line, and were taken to lie on it:", *moved);
  return first + " a rotation about that line moves none of them; a tool beside it tells this rotation";
}

}  // namespace

std::vector<std::string> unseen_reasons(const SetupShape& setup) {
  std::vector<std::string> reasons;
  if (setup.stations_mm.size() < stations_least)
    reasons.push_back(
        fmt::format("lengths from {} station{} leave ways in which the machine can bend without changing "
                    "one of them; three stations are the least, four or more are better",
                    setup.stations_mm.size(), setup.stations_mm.size() == 1 ? "" : "s"));
  else if (point_spread(setup.stations_mm, stations_apart_mm) != PointSpread::plane)
    reasons.emplace_back(
        "all stations stand within 10 mm of one line, and no length changes where points turn about it; a station "
        "beside this line tells such turns, more points do not");
  switch (tool_spread(setup.tools_mm)) {
    case PointSpread::point: reasons.push_back(one_tool_point(moved_text(setup.tools_mm))); break;
    case PointSpread::line: reasons.push_back(one_tool_line(moved_text(setup.tools_mm))); break;
    case PointSpread::plane: break;
  }
  if (reasons.empty())
    reasons.emplace_back(
        "the number of stations and tools and the lines they stand on do not show why; coarser curves ask for less, "
        "and more points, approached from other directions, tell more");
  return reasons;
}

std::optional<std::string> short_lever(std::span<const Vector3> offsets) {
  if (offsets.empty() || tool_spread(offsets) != PointSpread::plane) return std::nullopt;
  const PointReach reach = reach_of(offsets);
  const double length = norm(reach.along_mm);
  if (reach.beside_mm >= lever_share_least * length) return std::nullopt;
  return fmt::format(
      "the tool points lie within {:.1f} mm of one line, less than a twentieth of the {:.0f} mm that they are apart: "
      "rotations about this line are told by that lever alone, and a tool farther beside it would be moved by what "
      "they "
      "are wrong",
      reach.beside_mm, length);
}

std::string error_list(std::span<const std::size_t> errors) {
  const auto names = error_names();
  std::string text;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (k > 0) text += k + 1 == errors.size() ? " and " : ", ";
    text += names[errors[k]];
  }
  return text;
}

}  // namespace axiometry::volumetric
