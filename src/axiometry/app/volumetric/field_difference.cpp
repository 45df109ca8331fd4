// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/field_difference.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/volumetric/field/field_difference.h"

namespace axiometry::app {
namespace {

using formats::vector_value;
using json::Value;
using volumetric::ErrorModel;
using volumetric::Tool;

/// What a picture shows, µm.
double shown_um(double x) { return std::round(x * 1e4) / 1e4; }

Value grid_value(const ErrorModel& model, const Tool& tool, std::size_t nodes) {
  Value grid = Value::array();
  for (const auto& error : volumetric::grid_errors(model, tool.offset_mm, nodes))
    grid.push(error ? Value::array({shown_um(error->x), shown_um(error->y), shown_um(error->z)}) : Value());
  return grid;
}

const Tool* same_tool(const ErrorModel& model, const Tool& tool) {
  constexpr double alike_mm = 0.5;  // what its length changes when it is put in again
  const auto at = model.machine().tool_named(tool.name);
  if (!at || norm(model.machine().tools[*at].offset_mm - tool.offset_mm) > alike_mm) return nullptr;
  return &model.machine().tools[*at];
}

}  // namespace

Value field_value(const FieldVolume& volume) {
  Value value = json_of(volume);
  Value tools = Value::array();
  std::size_t k = 0;
  for (const Value& of_tool : value.find("tools")->items()) {
    const Tool& tool = volume.model.machine().tools[volume.fields[k++].tool];
    Value whole = of_tool;
    whole.add("offset_mm", vector_value(tool.offset_mm));
    whole.add("error_um", grid_value(volume.model, tool, volume.request.nodes));
    tools.push(std::move(whole));
  }
  Value root = Value::object();
  for (const auto& [name, member] : value.members())
    if (name != "tools") root.add(name, member);
  root.add("tools", std::move(tools));
  return root;
}

Result<Value> field_difference(const KeptModel& before, const KeptModel& after, std::size_t nodes) {
  const auto box = volumetric::common_travel(before.model, after.model);
  if (!box)
    return fail("found two results whose travels do not overlap, expected two of one machine: before and after");
  const KeptModel first{volumetric::seen_over(before.model, *box), before.against};
  KeptModel second{volumetric::seen_over(after.model, *box), after.against};
  const std::string &earlier = before.model.machine().name, &later = after.model.machine().name;
  if (!earlier.empty() && !later.empty() && earlier != later)
    second.against.push_back({"volumetric-two-machines", false,
                              fmt::format("found results of the machines {} and {}, expected two of one machine: what "
                                          "they differ by need not have changed",
                                          text::quoted(earlier), text::quoted(later))});
  Value tools = Value::array();
  for (const Tool& tool : second.model.machine().tools) {
    if (same_tool(first.model, tool) == nullptr) continue;
    const auto difference = volumetric::field_difference(first.model, second.model, tool.offset_mm, nodes);
    Value& item = tools.push(Value::object());
    item.add("tool", tool.name);
    item.add("offset_mm", vector_value(tool.offset_mm));
    item.add("as_found", sizes_value(difference.as_found));
    item.add("without_rigid_motion", sizes_value(difference.without_rigid_motion));
  }
  if (tools.items().empty())
    return fail("found no tool that both results have with the same name and offset, expected at least one");
  Value root = Value::object();
  root.add("nodes", nodes);
  root.add("before", field_value(field_volume(first, {{}, nodes})));
  root.add("after", field_value(field_volume(second, {{}, nodes})));
  root.add("tools", std::move(tools));
  return root;
}

}  // namespace axiometry::app
