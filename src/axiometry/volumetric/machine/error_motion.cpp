// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::volumetric {
namespace {

constexpr std::string_view motion_letters = "XYZABC";
constexpr std::string_view axis_letters = "XYZ";

}  // namespace

std::string error_name(ErrorMotion error) { return {'E', motion_letters[error.motion], axis_letters[error.axis]}; }

std::optional<ErrorMotion> error_motion_named(std::string_view name) {
  if (name.size() != 3 || name[0] != 'E') return std::nullopt;
  const std::size_t motion = motion_letters.find(name[1]), axis = axis_letters.find(name[2]);
  if (motion == std::string_view::npos || axis == std::string_view::npos) return std::nullopt;
  return ErrorMotion{axis, motion};
}

std::string_view error_kind(ErrorMotion error) {
  if (error.is_positioning()) return "positioning";
  if (error.is_straightness()) return "straightness";
  const std::size_t about = error.motion - first_rotation;
  if (about == error.axis) return "roll";
  // About the horizontal axis across the motion; of Z both are horizontal, and X is taken for that across.
  constexpr std::size_t pitch_about[] = {1, 0, 0};
  return about == pitch_about[error.axis] ? "pitch" : "yaw";
}

std::array<std::string, axis_count * motion_count + 3> error_names() {
  std::array<std::string, axis_count * motion_count + 3> names;
  std::size_t k = 0;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) names[k++] = error_name({a, m});
  for (const std::string_view name : squareness_names) names[k++] = name;
  return names;
}

}  // namespace axiometry::volumetric
