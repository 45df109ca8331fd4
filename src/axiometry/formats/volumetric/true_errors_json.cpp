// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/true_errors_json.h"

#include <fmt/format.h>

#include <cmath>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/machine_json.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;
using volumetric::axis_count;
using volumetric::ErrorMotion;
using volumetric::MachineModel;
using volumetric::motion_count;
using volumetric::TrueCurve;
using volumetric::TrueErrors;

constexpr double beyond_share = 0.05;

std::string point_text(const Vector3& at) {
  return fmt::format("({}, {}, {}) mm", format_exact(at.x), format_exact(at.y), format_exact(at.z));
}

/// Members that identify writes beside what is wanted are passed over.
Result<double> member_number(const Value& value, std::string_view name, std::string_view of) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, std::string(of)));
  AXIOMETRY_TRY(const Value* member, members.required(name));
  AXIOMETRY_TRY(const double number, number_in(*member, name));
  constexpr double most = 1e6;  // a metre
  if (std::abs(number) <= most) return number;
  return fail(fmt::format("found {} of {}, expected at most 1e6", name, number), member->at());
}

/// Half of what the directions differ by, where the item tells them.
Result<std::optional<double>> half_in(const Value& item, const std::string& name) {
  const Value *up = item.find("up"), *down = item.find("down");
  if (up == nullptr && down == nullptr) return std::nullopt;
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(item, name));
  AXIOMETRY_TRY(up, members.required("up"));
  AXIOMETRY_TRY(down, members.required("down"));
  AXIOMETRY_TRY(const double upward, member_number(*up, "value", name));
  AXIOMETRY_TRY(const double downward, member_number(*down, "value", name));
  return 0.5 * (upward - downward);
}

struct MeanAndHalf {
  TrueCurve mean, half;
};

Result<MeanAndHalf> curve_from(const Value& value, ErrorMotion error, const TravelBox& travel) {
  const std::string name = volumetric::error_name(error);
  AXIOMETRY_TRY(const std::vector<Value>* items, items_in(value, name));
  if (items->empty())
    return fail(fmt::format("found no value of {}, expected a table of positions and values", name), value.at());
  std::vector<TrueCurve::Node> nodes, halves;
  for (const Value& item : *items) {
    AXIOMETRY_TRY(const double position, member_number(item, "position", name));
    AXIOMETRY_TRY(const double number, member_number(item, "value", name));
    AXIOMETRY_TRY(const std::optional<double> half, half_in(item, name));
    const bool had_half = !halves.empty();
    if (!nodes.empty() && half.has_value() != had_half)
      return fail(
          fmt::format("found values of {} with and without those of each direction, expected one or the other", name),
          item.at());
    nodes.push_back({position, number});
    if (half) halves.push_back({position, *half});
  }
  auto curve = TrueCurve::make(std::move(nodes));
  if (!curve) return fail(fmt::format("{}: {}", name, curve.error().message), value.at());
  const double lowest = travel.lowest_mm[error.axis], highest = travel.highest_mm[error.axis];
  const double first = curve->nodes().front().position_mm, last = curve->nodes().back().position_mm;
  const double beyond = beyond_share * (highest - lowest);
  if (first > lowest + beyond || last < highest - beyond)
    return fail(fmt::format("found {} from {} to {} mm, expected it over the travel of {} to {} mm", name,
                            format_exact(first), format_exact(last), format_exact(lowest), format_exact(highest)),
                value.at());
  MeanAndHalf curves{*std::move(curve), {}};
  if (!halves.empty()) {
    AXIOMETRY_TRY(curves.half, TrueCurve::make(std::move(halves)));
  }
  return curves;
}

/// Of a truth, or within the model of a result; null where a file says nothing of its machine.
const Value* machine_in(const Value& root) {
  const auto member = [](const Value* value, std::string_view name) {
    return value != nullptr && value->is(Kind::object) ? value->find(name) : nullptr;
  };
  const Value* machine = member(&root, "machine");
  if (machine == nullptr) machine = member(member(&root, "model"), "machine");
  return machine != nullptr && machine->is(Kind::object) ? machine : nullptr;
}

Result<void> check_same_machine(const Value& root, const MachineModel& machine) {
  const Value* stated = machine_in(root);
  if (stated == nullptr) return {};
  AXIOMETRY_TRY(const MachineFile of_errors, machine_from(*stated));
  const MachineModel& other = of_errors.machine;
  if (!(other.chain == machine.chain))
    return fail(fmt::format("found errors of a machine of the chain {}, expected those of one of the chain {}",
                            other.chain.text(), machine.chain.text()),
                stated->at());
  for (std::size_t a = 0; a < axis_count; ++a)
    if (!(other.functional_point_mm[a] == machine.functional_point_mm[a]))
      return fail(fmt::format("found errors of {} about its functional point {}, expected about {}", "XYZ"[a],
                              point_text(other.functional_point_mm[a]), point_text(machine.functional_point_mm[a])),
                  stated->at());
  return {};
}

}  // namespace

Value true_errors_value(const TrueErrors& errors) {
  Value value = Value::object();
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const TrueCurve &curve = errors.curves[a][m], &half = errors.halves[a][m];
      if (curve.nodes().empty()) continue;
      Value& nodes = value.add(volumetric::error_name({a, m}), Value::array());
      for (const TrueCurve::Node& node : curve.nodes()) {
        Value& item = nodes.push(Value::object());
        item.add("position", node.position_mm);
        item.add("value", node.value);
        if (half.nodes().empty()) continue;
        const double differs = half.at(node.position_mm);
        item.add("up", Value::object()).add("value", node.value + differs);
        item.add("down", Value::object()).add("value", node.value - differs);
      }
    }
  for (std::size_t k = 0; k < volumetric::squareness_names.size(); ++k)
    value.add(volumetric::squareness_names[k], Value::object()).add("value", errors.squareness_urad[k]);
  return value;
}

Result<TrueErrors> read_true_errors(std::string_view bytes, const MachineModel& machine) {
  AXIOMETRY_TRY(const Value root, json::parse(bytes));
  AXIOMETRY_TRY_VOID(check_same_machine(root, machine));
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(root, "file of errors"));
  AXIOMETRY_TRY(const Value* list, members.required("errors"));
  if (!list->is(Kind::object))
    return fail(fmt::format("found {} for errors, expected an object", json::kind_name(list->kind())), list->at());
  TrueErrors errors;
  for (const auto& [name, value] : list->members()) {
    if (const auto error = volumetric::error_motion_named(name)) {
      AXIOMETRY_TRY(MeanAndHalf curves, curve_from(value, *error, machine.travel));
      errors.curves[error->axis][error->motion] = std::move(curves.mean);
      errors.halves[error->axis][error->motion] = std::move(curves.half);
      continue;
    }
    const auto which = std::ranges::find(volumetric::squareness_names, name);
    if (which == volumetric::squareness_names.end())
      return fail(fmt::format("found the error {}, expected EXX to ECZ, C0Y, B0Z or A0Z", text::quoted(name)),
                  value.at());
    AXIOMETRY_TRY(errors.squareness_urad[static_cast<std::size_t>(which - volumetric::squareness_names.begin())],
                  member_number(value, "value", name));
  }
  return errors;
}

}  // namespace axiometry::formats
