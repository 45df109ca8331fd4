// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <utility>

#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/test/metadata_json.h"
#include "axiometry/formats/test/test_schema.h"

namespace axiometry::formats {
namespace {

using json::Value;

Value axis_value(const Axis& axis) {
  Metadata metadata;
  metadata.axis = axis;
  Value object = Value::object();
  add_metadata(object, metadata);
  return *object.find("axis");
}

Value way_value(const std::vector<Vector3>& way) {
  Value list = Value::array();
  for (const Vector3& point : way) list.push(Value::array({point.x, point.y, point.z}));
  return list;
}

Value sequence_value(const std::vector<Approach>& sequence) {
  Value list = Value::array();
  for (const Approach& a : sequence)
    list.push(Value::array({a.target + 1, a.direction == Direction::up ? "up" : "down", a.run + 1}));
  return list;
}

}  // namespace

Value plan_value(const Plan& plan) {
  Value root = object({{"format", plan_format_name}, {"standard", plan.standard}});
  for (const auto& [name, text] :
       {std::pair{"clause", &plan.clause}, std::pair{"rule", &plan.rule}, std::pair{"title", &plan.title},
        std::pair{"machine", &plan.machine}, std::pair{"date", &plan.date}})
    if (!text->empty()) root.add(name, *text);
  root.add("axis", axis_value(plan.axis));
  Value errors = Value::array();
  for (const MotionName& error : plan.errors) errors.push(error.text());
  if (!plan.errors.empty()) root.add("errors", std::move(errors));
  root.add("cycle", cycle_name(plan.cycle));
  Value& targets = root.add("targets", Value::array());
  for (Position p : plan.targets) targets.push(p.in_native());
  root.add("runs", plan.runs);
  root.add("overrun", plan.overrun.in_native());
  root.add("feed", plan.feed);
  if (plan.acceleration) root.add("acceleration", *plan.acceleration);
  root.add("dwell_s", plan.dwell.in_s());
  root.add("warm_up_runs", plan.warm_up_runs);
  if (plan.seed) {
    const auto number = static_cast<double>(*plan.seed);
    root.add("seed", number < exact_whole_numbers ? Value(number) : Value(fmt::format("{}", *plan.seed)));
  }
  if (!plan.way_in_mm.empty()) root.add("way_in_mm", way_value(plan.way_in_mm));
  if (!plan.way_out_mm.empty()) root.add("way_out_mm", way_value(plan.way_out_mm));
  if (!plan.sequence.empty()) root.add("sequence", sequence_value(plan.sequence));
  if (!plan.further.empty()) {
    Value& parts = root.add("further", Value::array());
    for (const Plan& part : plan.further) parts.push(plan_value(part));
  }
  return root;
}

std::string write_plan(const Plan& plan) { return json::dump(plan_value(plan)) + "\n"; }

}  // namespace axiometry::formats
