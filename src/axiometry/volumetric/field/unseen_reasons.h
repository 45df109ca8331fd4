// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/base/vector3.h"

/// Why lengths do not tell some errors, in words, and what would tell them.
namespace axiometry::volumetric {

/// How the tool points that were used lie: a rotation that moves none of them is not seen.
enum class ToolSpread { point, line, plane };
/// Points within 1 mm of a line or point are on it.
ToolSpread tool_spread(std::span<const Vector3> offsets_mm);

struct SetupShape {
  std::vector<Vector3> tools_mm;     ///< offsets of those that were used
  std::vector<Vector3> stations_mm;  ///< different ones
};

/// Sentences without full stop; at least one.
std::vector<std::string> unseen_reasons(const SetupShape& setup);

/// "EXY, EAY and C0Y", from places in error_names().
std::string error_list(std::span<const std::size_t> errors);

}  // namespace axiometry::volumetric
