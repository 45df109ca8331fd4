// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "axiometry/volumetric/field/table_effect.h"

/// What can be done where a control compensates the positioning of each axis alone.
namespace axiometry::volumetric {

struct AxisTableNode {
  double position_mm = 0.0;
  Estimate deviation;  ///< deviation along the axis, less its mean, µm; of both directions
  Estimate up, down;   ///< less the same mean; alike where the errors do not differ by direction
};

struct AxisTables {
  bool has_directions = false;  ///< whether the errors tell the directions of all three axes apart
  std::array<std::vector<AxisTableNode>, axis_count> axes;
  TableEffect effect;
};

/// On lines through the middle of the volume: levers grow in proportion to the other axes' positions, so that no other
/// function of the axis alone leaves less (least squares over the volume). Between nodes a control draws straight
/// lines. Absent where the lengths do not tell the field with this tool. Contract: 2 ≤ nodes.
std::optional<AxisTables> axis_tables(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes);

}  // namespace axiometry::volumetric
