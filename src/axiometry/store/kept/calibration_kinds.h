// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

/// What a calibration may be of.
namespace axiometry::store {

/// "lines": of a plan, each after ISO 230-2; "volumetric": the 21 errors of a machine; and the other errors of one axis
/// or of two, from readings in µm or of angles, which are no tests of positions.
inline constexpr std::array<std::string_view, 5> calibration_kinds = {"lines", "volumetric", "straightness", "angles",
                                                                      "squareness"};
inline constexpr std::string_view calibration_kinds_text = "lines, volumetric, straightness, angles or squareness";

inline bool is_calibration_kind(std::string_view kind) {
  return std::ranges::find(calibration_kinds, kind) != calibration_kinds.end();
}

}  // namespace axiometry::store
