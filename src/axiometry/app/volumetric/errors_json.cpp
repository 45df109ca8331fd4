// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/errors_json.h"

#include <optional>

#include "axiometry/volumetric/field/curve_nodes.h"

namespace axiometry::app {
namespace {

using json::Value;

Value estimate_value(const std::optional<volumetric::Estimate>& estimate) {
  Value value = Value::object();
  value.add("value", estimate ? Value(estimate->value) : Value());
  value.add("u", estimate ? Value(estimate->u) : Value());
  return value;
}

}  // namespace

Value errors_value(const volumetric::ErrorModel& model) {
  Value errors = Value::object();
  const bool has_directions = model.coefficients().reversal() != volumetric::Reversal::none;
  for (std::size_t a = 0; a < volumetric::axis_count; ++a)
    for (std::size_t m = 0; m < volumetric::motion_count; ++m) {
      Value& nodes = errors.add(volumetric::error_name({a, m}), Value::array());
      for (const volumetric::CurveNode& node : volumetric::curve_nodes(model, {a, m})) {
        Value& item = nodes.push(Value::object());
        item.add("position", node.position_mm);
        item.add("value", node.mean.value);
        item.add("u", node.mean.u);
        if (!has_directions) continue;
        item.add("up", estimate_value(node.up));
        item.add("down", estimate_value(node.down));
      }
    }
  for (std::size_t k = 0; k < volumetric::squareness_names.size(); ++k) {
    const auto which = static_cast<volumetric::Squareness>(k);
    errors.add(volumetric::squareness_names[k], estimate_value(model.squareness(which)));
  }
  return errors;
}

}  // namespace axiometry::app
