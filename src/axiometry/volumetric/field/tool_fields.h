// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/volumetric/field/line_prediction.h"
#include "axiometry/volumetric/field/volume_statistics.h"

/// All that is told of the volume with one tool.
namespace axiometry::volumetric {

struct DiagonalOfTool {
  std::string name;
  std::optional<PredictedLine> predicted;  ///< absent where the lengths do not tell it
};
struct ToolField {
  std::size_t tool = 0;  ///< number of the tool in the machine
  VolumeStatistics statistics;
  std::vector<DiagonalOfTool> diagonals;
};

inline constexpr std::size_t field_nodes = 11;  ///< nodes along each axis, unless something else is asked for

/// Of every tool of the machine. Contract: as volume_statistics().
std::vector<ToolField> tool_fields(const ErrorModel& model, std::size_t nodes = field_nodes);

}  // namespace axiometry::volumetric
