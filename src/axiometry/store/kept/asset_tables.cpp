// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/asset_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"

namespace axiometry::store {
namespace {

std::string limits_text(const std::vector<Limit>& limits) {
  json::Value object = json::Value::object();
  for (const Limit& limit : limits) object.add(limit.parameter, limit.value);
  return json::dump(object, 0);
}

std::string inputs_text(const std::vector<std::pair<std::string, std::string>>& inputs) {
  json::Value object = json::Value::object();
  for (const auto& [key, text] : inputs) object.add(key, text);
  return json::dump(object, 0);
}

Result<json::Value> object_of(const std::string& text) {
  auto object = json::parse(text);
  if (!object || !object->is(json::Kind::object))
    return fail(ErrorKind::damaged, fmt::format("found {}, expected a JSON object", text::quoted(text)));
  return object;
}

Result<std::vector<Limit>> limits_of(const std::string& text) {
  AXIOMETRY_TRY(const json::Value object, object_of(text));
  std::vector<Limit> limits;
  for (const auto& [parameter, value] : object.members()) {
    if (!value.is(json::Kind::number))
      return fail(ErrorKind::damaged, fmt::format("found the limit {} without a number", text::quoted(parameter)));
    limits.push_back({parameter, value.number()});
  }
  return limits;
}

Result<std::vector<std::pair<std::string, std::string>>> inputs_of(const std::string& text) {
  AXIOMETRY_TRY(const json::Value object, object_of(text));
  std::vector<std::pair<std::string, std::string>> inputs;
  for (const auto& [key, value] : object.members()) {
    if (!value.is(json::Kind::text))
      return fail(ErrorKind::damaged, fmt::format("found the input {} without a text", text::quoted(key)));
    inputs.emplace_back(key, value.text());
  }
  return inputs;
}

Result<void> check_keys(std::vector<std::string_view> keys, std::string_view what) {
  std::ranges::sort(keys);
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k].empty() || (k > 0 && keys[k] == keys[k - 1]))
      return fail(fmt::format("found the {} {} {}, expected each once", what, text::quoted(keys[k]),
                              keys[k].empty() ? "without a name" : "twice"));
  return {};
}

}  // namespace

Result<void> check_exists(Connection& connection, std::string_view table, Id id) {
  AXIOMETRY_TRY(const Rows rows, connection.query(fmt::format("SELECT id FROM {} WHERE id = $1", table), {id}));
  if (rows.empty()) return fail(ErrorKind::not_found, fmt::format("found no {} {}, expected one", table, id));
  return {};
}

Result<void> check_content(Connection& connection, const std::string& sha256, std::string_view whose) {
  AXIOMETRY_TRY(const Rows rows, connection.query("SELECT id FROM content WHERE sha256 = $1", {sha256}));
  if (rows.empty())
    return fail(ErrorKind::not_found,
                fmt::format("found no bytes with the SHA-256 {}, expected {}", text::quoted(sha256), whose));
  return {};
}

std::vector<Cell> AssetTable<MachineRecord>::cells(const MachineRecord& m) {
  return {m.name, m.manufacturer, m.type, m.serial_number, m.controller, m.location, m.notes};
}

Result<MachineRecord> AssetTable<MachineRecord>::asset(const Row& row, std::size_t first) {
  return MachineRecord{.name = row.text(first),
                       .manufacturer = row.text(first + 1),
                       .type = row.text(first + 2),
                       .serial_number = row.text(first + 3),
                       .controller = row.text(first + 4),
                       .location = row.text(first + 5),
                       .notes = row.text(first + 6)};
}

Result<void> AssetTable<MachineRecord>::check(Connection&, const MachineRecord& machine) {
  if (text::trim(machine.name).empty()) return fail("found a machine without a name, expected one");
  return {};
}

std::string AssetTable<MachineRecord>::called(const MachineRecord& machine) { return machine.name; }

std::vector<Cell> AssetTable<AxisRecord>::cells(const AxisRecord& a) {
  return {a.machine, a.name, a.kind, limits_text(a.limits), a.notes};
}

Result<AxisRecord> AssetTable<AxisRecord>::asset(const Row& row, std::size_t first) {
  AXIOMETRY_TRY(std::vector<Limit> limits, limits_of(row.text(first + 3)));
  return AxisRecord{.machine = row.integer(first),
                    .name = row.text(first + 1),
                    .kind = row.text(first + 2),
                    .limits = std::move(limits),
                    .notes = row.text(first + 4)};
}

Result<void> AssetTable<AxisRecord>::check(Connection& connection, const AxisRecord& axis) {
  if (text::trim(axis.name).empty()) return fail("found an axis without a name, expected one");
  if (axis.kind != "linear" && axis.kind != "rotary")
    return fail(fmt::format("found the kind of axis {}, expected linear or rotary", text::quoted(axis.kind)));
  std::vector<std::string_view> keys;
  for (const Limit& limit : axis.limits) {
    keys.push_back(limit.parameter);
    if (!std::isfinite(limit.value) || limit.value <= 0)
      return fail(fmt::format("found the limit {} of {}, expected a number above 0", limit.value,
                              text::quoted(limit.parameter)));
  }
  AXIOMETRY_TRY_VOID(check_keys(std::move(keys), "limit"));
  return check_exists(connection, "machine", axis.machine);
}

std::string AssetTable<AxisRecord>::called(const AxisRecord& axis) { return axis.name; }

std::vector<Cell> AssetTable<InstrumentRecord>::cells(const InstrumentRecord& i) {
  return {i.role,
          i.manufacturer,
          i.type,
          i.serial_number,
          i.certificate,
          i.calibrated_on,
          i.calibration_due,
          inputs_text(i.inputs),
          i.notes};
}

Result<InstrumentRecord> AssetTable<InstrumentRecord>::asset(const Row& row, std::size_t first) {
  AXIOMETRY_TRY(auto inputs, inputs_of(row.text(first + 7)));
  return InstrumentRecord{.role = row.text(first),
                          .manufacturer = row.text(first + 1),
                          .type = row.text(first + 2),
                          .serial_number = row.text(first + 3),
                          .certificate = row.text(first + 4),
                          .calibrated_on = row.text(first + 5),
                          .calibration_due = row.text(first + 6),
                          .inputs = std::move(inputs),
                          .notes = row.text(first + 8)};
}

Result<void> AssetTable<InstrumentRecord>::check(Connection&, const InstrumentRecord& instrument) {
  if (text::trim(called(instrument)).empty())
    return fail("found an instrument without manufacturer, type, serial number and role, expected one of them");
  std::vector<std::string_view> keys;
  for (const auto& [key, text] : instrument.inputs) keys.push_back(key);
  return check_keys(std::move(keys), "input");
}

std::string AssetTable<InstrumentRecord>::called(const InstrumentRecord& i) {
  return fmt::format("{} {} {} {}", i.manufacturer, i.type, i.serial_number, i.role);
}

std::vector<Cell> AssetTable<PlanRecord>::cells(const PlanRecord& plan) {
  return {plan.title, plan.axis ? Cell(*plan.axis) : Cell(), plan.content};
}

Result<PlanRecord> AssetTable<PlanRecord>::asset(const Row& row, std::size_t first) {
  return PlanRecord{.title = row.text(first), .axis = row.optional_integer(first + 1), .content = row.text(first + 2)};
}

Result<void> AssetTable<PlanRecord>::check(Connection& connection, const PlanRecord& plan) {
  if (text::trim(plan.title).empty()) return fail("found a plan without a title, expected one");
  AXIOMETRY_TRY_VOID(check_content(connection, plan.content, "the plan's"));
  return plan.axis ? check_exists(connection, "axis", *plan.axis) : Result<void>();
}

std::string AssetTable<PlanRecord>::called(const PlanRecord& plan) { return plan.title; }

}  // namespace axiometry::store
