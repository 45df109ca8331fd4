// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/axis_tables.h"

#include <algorithm>

#include "axiometry/base/contract.h"
#include "axiometry/volumetric/field/field_rows.h"
#include "axiometry/volumetric/field/line_prediction.h"

namespace axiometry::volumetric {
namespace {

double between(const std::vector<AxisTableNode>& table, double position) {
  const auto above = std::ranges::upper_bound(table, position, {}, &AxisTableNode::position_mm);
  if (above == table.begin()) return table.front().deviation.value;
  if (above == table.end()) return table.back().deviation.value;
  const AxisTableNode &a = *(above - 1), &b = *above;
  return a.deviation.value +
         (b.deviation.value - a.deviation.value) * (position - a.position_mm) / (b.position_mm - a.position_mm);
}

}  // namespace

std::optional<AxisTables> axis_tables(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes) {
  AXIOMETRY_CONTRACT(nodes >= 2);
  AxisTables tables;
  tables.has_directions = model.coefficients().reversal() != Reversal::none;
  const Vector3 middle = place_in(model.observed(), {0.5, 0.5, 0.5});
  for (std::size_t a = 0; a < axis_count; ++a) {
    const auto line = predict_line(model, axis_line(model, a, middle, tool_mm, nodes));
    if (!line) return std::nullopt;
    tables.has_directions = tables.has_directions && line->has_directions;
    for (std::size_t k = 0; k < nodes; ++k)
      tables.axes[a].push_back(
          {line->line.positions_mm[k],
           {0.5 * (line->up[k].value + line->down[k].value), std::max(line->up[k].u, line->down[k].u)},
           line->up[k],
           line->down[k]});
  }
  const auto effect = table_effect(model, tool_mm, nodes, [&](Vector3 q) {
    return Vector3{between(tables.axes[0], q.x), between(tables.axes[1], q.y), between(tables.axes[2], q.z)};
  });
  if (!effect) return std::nullopt;
  tables.effect = *effect;
  return tables;
}

}  // namespace axiometry::volumetric
