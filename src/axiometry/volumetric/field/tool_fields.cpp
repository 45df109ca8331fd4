// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/tool_fields.h"

namespace axiometry::volumetric {

std::vector<ToolField> tool_fields(const ErrorModel& model, std::size_t nodes) {
  std::vector<ToolField> fields;
  for (std::size_t t = 0; t < model.machine().tools.size(); ++t) {
    const Vector3 tool = model.machine().tools[t].offset_mm;
    ToolField& field = fields.emplace_back(ToolField{t, volume_statistics(model, tool, nodes), {}});
    for (const std::string& name : diagonal_names())
      field.diagonals.push_back({name, predict_line(model, *diagonal_line(model, name, tool))});
  }
  return fields;
}

}  // namespace axiometry::volumetric
