// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/unseen_reasons.h"

#include <fmt/format.h>

#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::volumetric {
namespace {

constexpr double apart_mm = 1.0;
constexpr std::size_t stations_least = 3;

}  // namespace

ToolSpread tool_spread(std::span<const Vector3> offsets) {
  Vector3 along{};
  for (const Vector3& t : offsets)
    if (norm(t - offsets.front()) > norm(along)) along = t - offsets.front();
  if (norm(along) <= apart_mm) return ToolSpread::point;
  for (const Vector3& t : offsets)
    if (norm(cross(unit(along), t - offsets.front())) > apart_mm) return ToolSpread::plane;
  return ToolSpread::line;
}

std::vector<std::string> unseen_reasons(const SetupShape& setup) {
  std::vector<std::string> reasons;
  if (setup.stations_mm.size() < stations_least)
    reasons.push_back(
        fmt::format("lengths from {} station{} leave ways in which the machine can bend without changing "
                    "one of them; three stations are the least, four or more are better",
                    setup.stations_mm.size(), setup.stations_mm.size() == 1 ? "" : "s"));
  switch (tool_spread(setup.tools_mm)) {
    case ToolSpread::point:
      reasons.emplace_back(
          "all lengths have the same tool point, so that a rotation of an axis that nothing but the tool lies behind "
          "cannot be told from its straightness; three tools whose points form a triangle tell all (a short and a long "
          "one, and one beside them)");
      break;
    case ToolSpread::line:
      reasons.emplace_back(
          "all tool points lie on one line, and a rotation about that line moves none of them; a tool beside it tells "
          "this rotation");
      break;
    case ToolSpread::plane:
      if (reasons.empty())
        reasons.emplace_back(
            "the points that were measured, with the directions from which they were approached, do not suffice for "
            "curves "
            "as fine as these");
      break;
  }
  return reasons;
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
