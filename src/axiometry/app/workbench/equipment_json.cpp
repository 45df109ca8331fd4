// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/equipment_json.h"

#include <fmt/format.h>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;

template <typename Asset>
Value entity(const store::Versioned<Asset>& asset) {
  Value object = Value::object();
  object.add("id", id_value(asset.id));
  object.add("version", asset.version);
  object.add("change", to_json(asset.change));
  return object;
}

/// A text in its place among the members of an asset.
template <typename Asset>
struct TextMember {
  std::string_view name;
  std::string Asset::*text;
};

constexpr TextMember<store::MachineRecord> machine_lines[] = {
    {"name", &store::MachineRecord::name},
    {"manufacturer", &store::MachineRecord::manufacturer},
    {"type", &store::MachineRecord::type},
    {"serial_number", &store::MachineRecord::serial_number},
    {"controller", &store::MachineRecord::controller},
    {"location", &store::MachineRecord::location},
};

constexpr TextMember<store::InstrumentRecord> instrument_lines[] = {
    {"role", &store::InstrumentRecord::role},
    {"manufacturer", &store::InstrumentRecord::manufacturer},
    {"type", &store::InstrumentRecord::type},
    {"serial_number", &store::InstrumentRecord::serial_number},
    {"certificate", &store::InstrumentRecord::certificate},
    {"calibrated_on", &store::InstrumentRecord::calibrated_on},
    {"calibration_due", &store::InstrumentRecord::calibration_due},
};

template <typename Asset>
void add_lines(Value& object, const Asset& asset, std::span<const TextMember<Asset>> members) {
  for (const auto& [name, text] : members) object.add(name, asset.*text);
}

/// The error with the place of the member it belongs to.
std::unexpected<Error> at_member(const Value& object, std::string_view name, const Error& error) {
  const Value* member = object.find(name);
  return fail(error.message, member == nullptr ? object.at() : member->at());
}

template <typename Given>
Result<void> take_text(JsonMembers& members, const Value& object, std::string_view name, std::string& target,
                       const Given& given) {
  AXIOMETRY_TRY_VOID(members.take(name, target));
  auto text = given(name, target);
  if (!text) return at_member(object, name, text.error());
  target = *std::move(text);
  return {};
}

template <typename Asset>
Result<void> take_lines(JsonMembers& members, const Value& object, Asset& asset,
                        std::span<const TextMember<Asset>> texts) {
  for (const auto& [name, text] : texts) AXIOMETRY_TRY_VOID(take_text(members, object, name, asset.*text, &given_line));
  return take_text(members, object, "notes", asset.notes, &given_text);
}

/// "base_version", "reason", and what an answer has more than a request, which a page may send back.
template <typename Asset>
Result<void> take_edit(JsonMembers& members, const Value& object, Edit<Asset>& edit) {
  if (const Value* base = members.optional("base_version")) {
    AXIOMETRY_TRY(edit.base_version, given_version("base_version", *base));
  }
  AXIOMETRY_TRY_VOID(take_text(members, object, "reason", edit.reason, &given_line));
  for (const char* name : {"id", "version", "change", "axes", "tests", "latest_test", "latest_of_axes"})
    members.pass_over(name);
  return members.finish();
}

Result<void> check_date(const Value& object, std::string_view name, const std::string& text) {
  if (text.empty() || iso_date(text) == text) return {};
  const std::string found = fmt::format("found {} = {}, expected a date such as 2026-01-31", name, text::quoted(text));
  return at_member(object, name, Error{found, {}, {}});
}

/// Inputs that set_field_text() takes on a linear or on a rotary axis.
Result<void> check_inputs(const Changes& inputs, const Value& at) {
  for (const auto& [key, text] : inputs) {
    Metadata trial;
    const std::vector<std::pair<std::string, std::string>> item = metadata_items({{key, text}});
    if (auto set = set_metadata(trial, item); !set) return at_member(at, key, set.error());
  }
  return {};
}

void add_latest(Value& object, const store::LatestTest& test) {
  object.add("id", id_value(test.test));
  object.add("measured_on", test.measured_on);
  object.add("received_at", test.received_at);
  object.add("verdict", text_or_null(test.verdict));
}

}  // namespace

json::Value to_json(const store::Versioned<store::MachineRecord>& machine) {
  Value object = entity(machine);
  add_lines<store::MachineRecord>(object, machine.value, machine_lines);
  object.add("notes", machine.value.notes);
  return object;
}

json::Value to_json(const MachineSummary& summary) {
  Value object = to_json(summary.machine);
  Value& axes = object.add("axes", Value::array());
  for (const auto& axis : summary.axes) axes.push(to_json(axis));
  object.add("tests", summary.tests ? static_cast<double>(summary.tests->total) : 0.0);
  Value& latest = object.add("latest_test", Value());
  if (summary.tests) {
    latest = Value::object();
    add_latest(latest, summary.tests->latest);
  }
  Value& of_axes = object.add("latest_of_axes", Value::array());
  for (const store::AxisLatest& of_one : summary.of_axes) {
    Value& row = of_axes.push(Value::object());
    row.add("axis", id_value(of_one.axis));
    add_latest(row, of_one.latest);
  }
  return object;
}

json::Value to_json(const store::Versioned<store::AxisRecord>& axis) {
  Value object = entity(axis);
  object.add("machine", id_value(axis.value.machine));
  object.add("name", axis.value.name);
  object.add("kind", axis.value.kind);
  object.add("limits", limits_to_json(axis.value.limits));
  object.add("notes", axis.value.notes);
  return object;
}

json::Value to_json(const store::Versioned<store::InstrumentRecord>& instrument) {
  Value object = entity(instrument);
  add_lines<store::InstrumentRecord>(object, instrument.value, instrument_lines);
  object.add("inputs", to_json(instrument.value.inputs));
  object.add("notes", instrument.value.notes);
  return object;
}

json::Value to_json(const store::AuditEntry& entry) {
  const auto detail = json::parse(entry.detail);
  Value object = Value::object();
  object.add("id", id_value(entry.id));
  object.add("change", to_json(entry.change));
  object.add("action", entry.action);
  object.add("subject", entry.subject);
  object.add("detail", detail ? *detail : Value::object());
  object.add("sha256", entry.sha256);
  return object;
}

json::Value to_json(const AxisTrend& trend) {
  Value machine = Value::object();
  machine.add("id", id_value(trend.axis.value.machine));
  machine.add("name", trend.machine_name);
  Value points = Value::array();
  for (const store::TrendPoint& point : trend.points) {
    Value& row = points.push(Value::object());
    row.add("test", id_value(point.test));
    row.add("version", point.version);
    row.add("title", point.title);
    row.add("measured_on", point.measured_on);
    row.add("received_at", point.received_at);
    row.add("conforming", point.conforming);
    row.add("label", point.label);
    row.add("verdict", point.verdict.empty() ? Value() : Value(point.verdict));
    row.add("figures", figures_to_json(point.figures));
    Value& others = row.add("same_bytes", Value::array());
    for (const store::Id test : point.same_bytes) others.push(id_value(test));
  }
  Value object = Value::object();
  object.add("axis", to_json(trend.axis));
  object.add("machine", std::move(machine));
  object.add("unit", trend.axis.value.kind == axis_kind_name(AxisKind::rotary) ? deviation_unit_key(AxisKind::rotary)
                                                                               : deviation_unit_key(AxisKind::linear));
  object.add("points", std::move(points));
  return object;
}

Result<Edit<store::MachineRecord>> machine_from(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "machine"));
  Edit<store::MachineRecord> edit;
  AXIOMETRY_TRY_VOID(take_lines<store::MachineRecord>(members, value, edit.value, machine_lines));
  AXIOMETRY_TRY_VOID(take_edit(members, value, edit));
  if (edit.value.name.empty()) return fail("found a machine without a name, expected one", value.at());
  return edit;
}

Result<Edit<store::AxisRecord>> axis_from(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "axis"));
  Edit<store::AxisRecord> edit;
  store::AxisRecord& axis = edit.value;
  AXIOMETRY_TRY(const Value* machine, members.required("machine"));
  AXIOMETRY_TRY(axis.machine, given_number("machine", *machine));
  AXIOMETRY_TRY_VOID(take_text(members, value, "name", axis.name, &given_line));
  AXIOMETRY_TRY_VOID(take_text(members, value, "kind", axis.kind, &given_line));
  AXIOMETRY_TRY_VOID(take_text(members, value, "notes", axis.notes, &given_text));
  if (const Value* limits = members.optional("limits")) {
    AXIOMETRY_TRY(axis.limits, limits_from(*limits));
  }
  AXIOMETRY_TRY_VOID(take_edit(members, value, edit));
  if (axis.name.empty()) return fail("found an axis without a name, expected one such as X", value.at());
  if (axis.kind != "linear" && axis.kind != "rotary")
    return fail(fmt::format("found the kind {} of an axis, expected linear or rotary", text::quoted(axis.kind)),
                value.at());
  return edit;
}

Result<Edit<store::InstrumentRecord>> instrument_from(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "instrument"));
  Edit<store::InstrumentRecord> edit;
  store::InstrumentRecord& instrument = edit.value;
  AXIOMETRY_TRY_VOID(take_lines<store::InstrumentRecord>(members, value, instrument, instrument_lines));
  AXIOMETRY_TRY_VOID(check_date(value, "calibrated_on", instrument.calibrated_on));
  AXIOMETRY_TRY_VOID(check_date(value, "calibration_due", instrument.calibration_due));
  if (const std::string& on = instrument.calibrated_on, &due = instrument.calibration_due;
      !on.empty() && !due.empty() && due < on)
    return at_member(
        value, "calibration_due",
        Error{fmt::format("found the day {}, expected one not before the calibration of {}", due, on), {}, {}});
  if (const Value* inputs = members.optional("inputs")) {
    AXIOMETRY_TRY(instrument.inputs, changes_from(*inputs));
    AXIOMETRY_TRY_VOID(check_inputs(instrument.inputs, *inputs));
  }
  AXIOMETRY_TRY_VOID(take_edit(members, value, edit));
  if (instrument_name(instrument).empty())
    return fail("found an instrument without manufacturer, type, serial number and role, expected one of them",
                value.at());
  return edit;
}

Result<std::string> reason_from(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "request"));
  std::string reason;
  AXIOMETRY_TRY_VOID(take_text(members, value, "reason", reason, &given_line));
  AXIOMETRY_TRY_VOID(members.finish());
  return reason;
}

}  // namespace axiometry::app
