// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/workbench_json.h"

#include <cmath>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/app/workbench/shown_json.h"
#include "axiometry/app/workbench/test_state.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/simulated.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Kind;
using json::Value;

std::string_view name_of(OtherFile file) {
  constexpr std::string_view names[] = {"recording", "error-motion", "plan", "temperatures"};
  return names[static_cast<std::size_t>(file)];
}

Value runs_to_json(const Series& series, Direction direction) {
  Value rows = Value::array();
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    Value& row = rows.push(Value::array());
    for (const double x : series.cell(i, direction)) row.push(std::isnan(x) ? Value() : Value(x));
  }
  return rows;
}

void add_runs(Value& object, const Series& series) {
  object.add("up", runs_to_json(series, Direction::up));
  object.add("down", runs_to_json(series, Direction::down));
}

Value outcome_readings_to_json(const Outcome& outcome) {
  Value object = Value::object();
  Value& targets = object.add("targets", Value::array());
  for (const Position target : outcome.readings.targets()) targets.push(target.in_native());
  add_runs(object, outcome.readings);
  Value& measured = object.add("as_measured", Value());
  if (!outcome.as_measured) return object;
  measured = Value::object();
  add_runs(measured, *outcome.as_measured);
  return object;
}

/// Whether the date of the test says that there is none, since nothing was measured.
bool is_simulated_undated(const Value& result) {
  const Value* date = &result;
  for (const std::string_view name : {"metadata", "test", "date"})
    if (date != nullptr) date = member_of_object(*date, name);
  return date != nullptr && date->is(json::Kind::text) && date->text() == simulated_date;
}

/// Adds the members of Evaluated.
void add_outcome(Value& object, const Outcome& outcome, const Reader& reader) {
  object.add("result", localised_result(outcome.result, ResultKind::test, reader));
  object.add("readings", outcome_readings_to_json(outcome));
  object.add("verdict", verdict_or_null(member_of_object(outcome.result, "verdict")));
  object.add("shown", shown_to_json(outcome.result, reader));
  object.add("from_archive", to_json(outcome.from_archive));
  object.add("simulated_undated", is_simulated_undated(outcome.result));
  object.add("milliseconds", std::round(outcome.milliseconds * 1000.0) / 1000.0);
}

Value row_to_json(const store::TestRow& row, const Reader& reader) {
  Value object = Value::object();
  object.add("id", id_value(row.id));
  object.add("version", row.version);
  object.add("title", row.title);
  object.add("file_name", row.file_name);
  object.add("machine", row.machine ? id_and_name(*row.machine, row.machine_name) : Value());
  Value& axis = object.add("axis", row.axis ? id_and_name(*row.axis, row.axis_name) : Value());
  if (row.axis) axis.add("kind", row.axis_kind);
  object.add("unit", row.unit);
  object.add("measured_on", row.measured_on);
  object.add("received_at", row.received_at);
  object.add("conforming", row.conforming);
  object.add("withdrawn", row.withdrawn);
  object.add("verdict", text_or_null(row.verdict));
  object.add("label", row.label.empty() ? "" : language::translated(row.label, reader.language));
  object.add("figures", figures_to_json(row.figures));
  return object;
}

Value previewed_to_json(const PreviewedTest& test, const Reader& reader) {
  const Metadata& metadata = test.metadata;
  const Series& series = test.readings;
  Value object = Value::object();
  object.add("name", test.name);
  object.add("axis", metadata.axis.name);
  object.add("kind", axis_kind_name(metadata.axis.kind));
  object.add("machine", metadata.machine.name);
  object.add("measured_on", iso_date(metadata.conditions.date));
  object.add("targets", series.target_count());
  object.add("runs", most_runs_made(series));
  object.add("readings", series.reading_count());
  object.add("first", series.targets().front().in_native());
  object.add("last", series.targets().back().in_native());
  object.add("unit", deviation_unit_key(metadata.axis.kind));
  object.add("evaluated", test.outcome ? to_json(*test.outcome, reader) : Value());
  return object;
}

Value texts_to_json(std::span<const std::string> texts) {
  Value list = Value::array();
  for (const std::string& text : texts) list.push(report::printable(text));
  return list;
}

Value table_to_json(const AskedTable& table, const Reader& reader) {
  Value object = Value::object();
  object.add("profile", formats::profile_to_json(table.profile));
  Value& questions = object.add("questions", Value::array());
  for (const formats::GuessDecision& question : table.questions) {
    Value& row = questions.push(Value::object());
    row.add("key", question.key);
    row.add("text", language::translated(question.reason, reader.language, reader.numbers));
  }
  object.add("names", texts_to_json(table.names));
  Value& rows = object.add("rows", Value::array());
  for (const std::vector<std::string>& row : table.rows) rows.push(texts_to_json(row));
  return object;
}

Value ids_to_json(std::span<const store::Id> ids) {
  Value list = Value::array();
  for (const store::Id id : ids) list.push(id_value(id));
  return list;
}

Value kept_file_to_json(const KeptTest& kept) {
  Value file = Value::object();
  file.add("name", kept.record.file_name);
  file.add("sha256", kept.record.sha256);
  file.add("size", kept.size);
  file.add("format", kept.record.format);
  file.add("name_in_file", kept.record.name_in_file);
  file.add("profile", kept.profile ? formats::profile_to_json(*kept.profile) : Value());
  return file;
}

void add_equipment_members(Value& object, const KeptTest& kept) {
  const store::TestRecord& record = kept.record;
  object.add("machine", kept.machine ? id_and_name(*record.machine, kept.machine->name) : Value());
  Value& axis = object.add("axis", kept.axis ? id_and_name(*record.axis, kept.axis->name) : Value());
  if (kept.axis) {
    axis.add("kind", kept.axis->kind);
    axis.add("limits", limits_to_json(kept.axis->limits));
  }
  Value& instruments = object.add("instruments", Value::array());
  for (const auto& instrument : kept.instruments) {
    Value& row = instruments.push(id_and_name(instrument.id, instrument_name(instrument.value)));
    row.add("calibration_due", instrument.value.calibration_due);
  }
}

}  // namespace

json::Value id_value(store::Id id) { return static_cast<double>(id); }

json::Value id_and_name(store::Id id, const std::string& name) {
  Value object = Value::object();
  object.add("id", id_value(id));
  object.add("name", name);
  return object;
}

json::Value text_or_null(const std::string& text) { return text.empty() ? Value() : Value(text); }

json::Value to_json(const Outcome& outcome, const Reader& reader) {
  Value object = Value::object();
  add_outcome(object, outcome, reader);
  return object;
}

json::Value to_json(const Preview& preview, const Reader& reader) {
  Value object = Value::object();
  Value& file = object.add("file", Value::object());
  file.add("name", preview.file_name);
  file.add("size", preview.size);
  file.add("sha256", preview.sha256);
  Value& format = object.add("format", Value());
  if (const formats::Format* known = formats::find_format(preview.format)) {
    format = Value::object();
    format.add("id", known->id);
    format.add("title", language::translated(known->title, reader.language));
  }
  object.add("refused", preview.refused ? error_to_json(*preview.refused, reader) : Value());
  object.add("instead", preview.instead ? Value(name_of(*preview.instead)) : Value());
  Value& tests = object.add("tests", Value::array());
  for (const PreviewedTest& test : preview.tests) tests.push(previewed_to_json(test, reader));
  object.add("same_content", ids_to_json(preview.same_content));
  object.add("table", preview.table ? table_to_json(*preview.table, reader) : Value());
  return object;
}

json::Value to_json(const Received& received, const Reader& reader) {
  Value object = Value::object();
  object.add("id", id_value(received.tests.front().id));
  object.add("version", 1);
  Value& tests = object.add("tests", Value::array());
  for (const ReceivedTest& test : received.tests) {
    Value& row = tests.push(Value::object());
    row.add("id", id_value(test.id));
    row.add("version", 1);
    row.add("title", test.title);
    row.add("same_content", ids_to_json(test.same_content));
    Value& remarks = row.add("remarks", Value::array());
    for (const std::string& remark : test.remarks)
      remarks.push(language::translated(remark, reader.language, reader.numbers));
  }
  object.add("same_content", ids_to_json(received.same_content));
  add_outcome(object, received.first, reader);
  return object;
}

json::Value to_json(const KeptTest& kept, const Reader& reader) {
  const store::TestRecord& record = kept.record;
  Value object = Value::object();
  object.add("id", id_value(record.id));
  object.add("version", record.version);
  object.add("latest", record.latest);
  object.add("title", record.state.title);
  object.add("file", kept_file_to_json(kept));
  object.add("received", to_json(record.received));
  Value& versions = object.add("versions", Value::array());
  for (std::size_t k = 0; k < kept.versions.size(); ++k) {
    Value& row = versions.push(to_json(kept.versions[k]));
    row.add("version", k + 1);
  }
  object.add("withdrawn", record.withdrawn);
  add_equipment_members(object, kept);
  object.add("plan", record.state.plan ? id_value(*record.state.plan) : Value());
  object.add("changes", to_json(kept.draft.changes));
  object.add("options", to_json(kept.draft.options));
  Value& documents = object.add("documents", Value::array());
  for (const store::DocumentRecord& document : kept.documents) documents.push(to_json(document));
  add_outcome(object, kept.outcome, reader);
  return object;
}

json::Value to_json(const store::TestPage& page, const Reader& reader) {
  Value object = Value::object();
  Value& tests = object.add("tests", Value::array());
  for (const store::TestRow& row : page.rows) tests.push(row_to_json(row, reader));
  object.add("total", static_cast<double>(page.total));
  return object;
}

json::Value to_json(const store::DocumentRecord& document) {
  Value object = Value::object();
  object.add("id", id_value(document.id));
  object.add("test", id_value(document.test));
  object.add("version", document.version);
  object.add("kind", document.kind == store::DocumentRecord::Kind::report ? "report" : "attachment");
  object.add("name", document.name);
  object.add("media_type", document.media_type);
  object.add("language", document.language);
  object.add("sha256", document.sha256);
  object.add("size", static_cast<double>(document.size));
  object.add("change", to_json(document.change));
  return object;
}

json::Value to_json(const store::Change& change) {
  Value object = Value::object();
  object.add("at", change.at);
  object.add("actor", change.actor);
  object.add("reason", change.reason);
  return object;
}

json::Value figures_to_json(std::span<const store::FigureRecord> figures) {
  Value list = Value::array();
  for (const store::FigureRecord& figure : figures) {
    Value& row = list.push(Value::object());
    row.add("parameter", figure.parameter);
    row.add("value", figure.value);
    row.add("U", number_or_null(figure.U));
    row.add("low", number_or_null(figure.low));
    row.add("high", number_or_null(figure.high));
    row.add("method", figure.method.empty() ? Value() : Value(figure.method));
    row.add("limit", number_or_null(figure.limit));
    row.add("verdict", text_or_null(figure.verdict));
  }
  return list;
}

json::Value error_to_json(const Error& error, const Reader& reader) {
  const auto place = [](std::size_t count) { return count == 0 ? Value() : Value(count); };
  Value object = Value::object();
  object.add("kind", "bad_input");
  object.add("message", language::translated(error.message, reader.language));
  object.add("file", text_or_null(error.file));
  object.add("line", place(error.at.line));
  object.add("column", place(error.at.column));
  return object;
}

Result<Draft> draft_from(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "request"));
  Draft draft;
  if (const Value* changes = members.optional("changes")) {
    AXIOMETRY_TRY(draft.changes, changes_from(*changes));
  }
  if (const Value* options = members.optional("options")) {
    AXIOMETRY_TRY(draft.options, test_options_from(*options));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return draft;
}

Result<Revision> revision_from(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "request"));
  Revision revision;
  AXIOMETRY_TRY(const Value* base, members.required("base_version"));
  AXIOMETRY_TRY(revision.base_version, given_version("base_version", *base));
  AXIOMETRY_TRY_VOID(members.take("title", revision.title));
  AXIOMETRY_TRY_VOID(members.take("reason", revision.reason));
  AXIOMETRY_TRY(revision.reason, given_line("reason", revision.reason));
  if (const Value* plan = members.optional("plan")) {
    AXIOMETRY_TRY(revision.plan, given_number("plan", *plan));
  }
  if (const Value* changes = members.optional("changes")) {
    AXIOMETRY_TRY(revision.draft.changes, changes_from(*changes));
  }
  if (const Value* options = members.optional("options")) {
    AXIOMETRY_TRY(revision.draft.options, test_options_from(*options));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return revision;
}

}  // namespace axiometry::app
