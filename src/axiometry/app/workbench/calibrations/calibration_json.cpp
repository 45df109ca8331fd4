// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/calibrations/calibration_json.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/app/files/given_members.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/workbench/kept_records.h"
#include "axiometry/app/workbench/workbench_json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;
using store::CalibrationRecord;
using store::Versioned;

Value number_or_none(const std::optional<double>& number) { return number ? Value(*number) : Value(); }

Value figures_value(const std::vector<store::KeptFigure>& figures) {
  Value list = Value::array();
  for (const store::KeptFigure& figure : figures) {
    Value& item = list.push(Value::object());
    item.add("parameter", figure.parameter);
    item.add("of", figure.of);
    item.add("value", figure.value);
    item.add("u", number_or_none(figure.u));
    item.add("unit", figure.unit);
  }
  return list;
}

/// What stands in lists and on the page alike.
Value head_of(const Versioned<CalibrationRecord>& calibration, Value machine) {
  const CalibrationRecord& c = calibration.value;
  Value object = Value::object();
  object.add("id", id_value(calibration.id));
  object.add("version", calibration.version);
  object.add("kind", c.kind);
  object.add("title", c.title);
  object.add("machine", std::move(machine));
  object.add("measured_on", c.measured_on);
  object.add("withdrawn", c.withdrawn);
  object.add("verdict", text_or_null(c.verdict));
  object.add("serious", c.serious);
  object.add("figures", figures_value(c.figures));
  return object;
}

Value head_of(const KeptCalibration& kept) {
  return head_of(kept.calibration, kept.machine ? id_and_name(kept.machine->id, kept.machine->value.name) : Value());
}

Value files_value(const CalibrationRecord& c) {
  Value list = Value::array();
  for (const store::KeptFile& file : c.files) {
    Value& item = list.push(Value::object());
    item.add("role", file.role);
    item.add("name", file.name);
    item.add("sha256", file.content);
  }
  return list;
}

Value versions_value(const std::vector<Versioned<CalibrationRecord>>& versions) {
  Value list = Value::array();
  for (const auto& version : versions) {
    Value& item = list.push(Value::object());
    item.add("version", version.version);
    item.add("change", to_json(version.change));
    item.add("title", version.value.title);
    item.add("withdrawn", version.value.withdrawn);
    item.add("result_sha256", version.value.result);
  }
  return list;
}

Result<void> take_date(JsonMembers& members, std::optional<std::string>& target) {
  AXIOMETRY_TRY_VOID(take_given(members, "measured_on", target, &given_line));
  if (!target || target->empty() || iso_date(*target) == *target) return {};
  return fail(fmt::format("found measured_on = {}, expected a date such as 2026-01-31", text::quoted(*target)),
              members.optional("measured_on")->at());
}

Result<void> take_said(JsonMembers& members, const Value& object, CalibrationRevision& said) {
  AXIOMETRY_TRY_VOID(take_given(members, "title", said.title, &given_line));
  AXIOMETRY_TRY_VOID(take_id(members, object, "machine", said.machine));
  AXIOMETRY_TRY_VOID(take_id(members, object, "instrument", said.instrument));
  AXIOMETRY_TRY_VOID(take_date(members, said.measured_on));
  return take_given(members, "notes", said.notes, &given_text);
}

}  // namespace

Value to_json(const store::CalibrationPage& page) {
  Value object = Value::object();
  Value& rows = object.add("calibrations", Value::array());
  for (const store::CalibrationRow& row : page.rows) {
    const auto& machine = row.calibration.value.machine;
    Value& line = rows.push(head_of(row.calibration, machine ? id_and_name(*machine, row.machine_name) : Value()));
    line.add("received_at", row.received_at);
  }
  object.add("total", static_cast<double>(page.total));
  return object;
}

Value to_json(const KeptCalibration& kept, const Reader& reader) {
  const CalibrationRecord& c = kept.calibration.value;
  Value object = head_of(kept);
  object.add("change", to_json(kept.calibration.change));
  object.add("instrument",
             kept.instrument ? id_and_name(kept.instrument->id, instrument_name(kept.instrument->value)) : Value());
  object.add("notes", c.notes);
  object.add("files", files_value(c));
  object.add("program", c.program);
  object.add("options", object_of_text(c.options));
  object.add("versions", versions_value(kept.versions));
  if (kept.same_files) {
    Value& same = object.add("same_files", Value::array());
    for (const store::Id id : *kept.same_files) same.push(id_value(id));
  }
  object.add("result", localised_result(kept.result, result_kind_of_calibration(c.kind), reader));
  return object;
}

Value to_json(const CalibrationComparison& comparison) {
  Value object = Value::object();
  object.add("before", head_of(comparison.before));
  object.add("after", head_of(comparison.after));
  Value& rows = object.add("rows", Value::array());
  for (const ComparedFigure& row : comparison.rows) {
    Value& item = rows.push(Value::object());
    item.add("parameter", row.parameter);
    item.add("of", row.of);
    item.add("unit", row.unit);
    item.add("before", number_or_none(row.before));
    item.add("before_u", number_or_none(row.before_u));
    item.add("after", number_or_none(row.after));
    item.add("after_u", number_or_none(row.after_u));
    item.add("difference", row.before && row.after ? Value(*row.after - *row.before) : Value());
  }
  return object;
}

Result<NewCalibration> new_calibration_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "about"));
  CalibrationRevision said;
  AXIOMETRY_TRY_VOID(take_said(members, value, said));
  AXIOMETRY_TRY_VOID(members.finish());
  NewCalibration calibration;
  calibration.title = said.title.value_or("");
  calibration.machine = said.machine.value_or(std::nullopt);
  calibration.instrument = said.instrument.value_or(std::nullopt);
  calibration.measured_on = said.measured_on.value_or("");
  calibration.notes = said.notes.value_or("");
  return calibration;
}

Result<CalibrationRevision> calibration_revision_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "revision"));
  CalibrationRevision revision;
  AXIOMETRY_TRY(RevisionHead head, revision_head(members));
  revision.base_version = head.base_version;
  revision.reason = std::move(head.reason);
  AXIOMETRY_TRY_VOID(take_said(members, value, revision));
  if (const Value* options = members.optional("options")) revision.options = *options;
  AXIOMETRY_TRY_VOID(members.finish());
  return revision;
}

}  // namespace axiometry::app
