// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/vector3.h"

/// Why lengths do not tell some errors, in words, and what would tell them.
namespace axiometry::volumetric {

struct SetupShape {
  std::vector<Vector3> tools_mm;     ///< offsets, as stated, of those that were used; at least one
  std::vector<Vector3> stations_mm;  ///< different ones
};

/// Sentences without full stop; at least one.
std::vector<std::string> unseen_reasons(const SetupShape& setup);

/// Of tools whose points all but stand on one line (beside it less than a twentieth of how far they are apart), a
/// sentence without full stop: rotations about the line have a number with a lever that short. Nothing of others, and
/// nothing of those on a line, of which unseen_reasons() tells.
std::optional<std::string> short_lever(std::span<const Vector3> offsets_mm);

/// "EXY, EAY and C0Y", from places in error_names().
std::string error_list(std::span<const std::size_t> errors);

}  // namespace axiometry::volumetric
