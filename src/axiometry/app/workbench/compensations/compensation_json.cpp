// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/compensations/compensation_json.h"

#include <algorithm>
#include <array>
#include <utility>

#include "axiometry/app/files/given_members.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/workbench/kept_records.h"
#include "axiometry/app/workbench/workbench_json.h"
#include "axiometry/language/language.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;
using store::CompensationRecord;
using store::Versioned;

constexpr std::array states = {"before", "predicted", "percent_95", "retest"};

Value test_value(const TestOfCompensation& test) {
  Value object = Value::object();
  object.add("id", id_value(test.id));
  object.add("version", test.version);
  object.add("title", test.title);
  object.add("measured_on", test.measured_on);
  object.add("latest", test.latest);
  object.add("withdrawn", test.withdrawn);
  object.add("revised", test.revised);
  return object;
}

/// One row for each parameter, in the order in which they were kept, with what is known of it and still counts.
Value course_value(const std::vector<store::KeptFigure>& figures, bool retest_counts) {
  Value rows = Value::array();
  std::vector<std::string_view> parameters;
  for (const store::KeptFigure& figure : figures)
    if (std::ranges::find(parameters, figure.parameter) == parameters.end()) parameters.emplace_back(figure.parameter);
  for (const std::string_view parameter : parameters) {
    Value& row = rows.push(Value::object());
    row.add("parameter", parameter);
    for (const char* state : states) {
      const auto found = std::ranges::find_if(
          figures, [&](const store::KeptFigure& f) { return f.parameter == parameter && f.of == state; });
      const bool counts = found != figures.end() && (found->of != "retest" || retest_counts);
      row.add(state, counts ? Value(found->value) : Value());
    }
  }
  return rows;
}

std::string_view unit_of(const CompensationRecord& c) {
  return c.figures.empty() ? "um" : std::string_view(c.figures[0].unit);
}

/// A control that this program does not know any more is called by its id.
Value control_value(const std::string& id, const Reader& reader) {
  const auto control = nc::axis_table_named(id);
  Value object = Value::object();
  object.add("id", id);
  object.add("title", control ? language::translated((*control)->title, reader.language, reader.numbers) : id);
  return object;
}

/// What stands in lists and on the page alike.
Value head_value(const ListedCompensation& listed, const Reader& reader) {
  const CompensationRecord& c = listed.compensation.value;
  const store::KeptFile* table = file_of(c.files, "table");
  Value object = Value::object();
  object.add("id", id_value(listed.compensation.id));
  object.add("version", listed.compensation.version);
  object.add("made_at", listed.made_at);
  object.add("control", control_value(c.control, reader));
  object.add("file_name", table == nullptr ? std::string() : table->name);
  object.add("test", test_value(listed.test));
  object.add("retest", listed.retest ? test_value(*listed.retest) : Value());
  object.add("machine", listed.machine ? id_and_name(listed.machine->id, listed.machine->value.name) : Value());
  object.add("axis", listed.axis ? id_and_name(listed.axis->id, listed.axis->value.name) : Value());
  object.add("unit", unit_of(c));
  object.add("notes", c.notes);
  object.add("withdrawn", c.withdrawn);
  object.add("serious", listed.serious);
  object.add("figures", course_value(c.figures, listed.retest_counts()));
  return object;
}

Value table_versions_value(const std::vector<Versioned<CompensationRecord>>& versions) {
  Value list = Value::array();
  for (const auto& version : versions) {
    Value& item = list.push(Value::object());
    item.add("version", version.version);
    item.add("change", to_json(version.change));
    item.add("retest", version.value.retest ? id_value(*version.value.retest) : Value());
    item.add("withdrawn", version.value.withdrawn);
  }
  return list;
}

Value counting_value(const std::vector<KeptFinding>& findings, const Reader& reader) {
  Value list = Value::array();
  for (const KeptFinding& finding : findings) {
    Value& item = list.push(Value::object());
    item.add("id", finding.id);
    item.add("severity", finding.severity);
    item.add("message", finding.message);
  }
  return localised_result(list, ResultKind::findings, reader);
}

Value existing_value(const CompensationRecord& c) {
  const store::KeptFile* existing = file_of(c.files, "existing");
  if (existing == nullptr) return {};
  Value object = Value::object();
  object.add("name", existing->name);
  object.add("sha256", existing->content);
  return object;
}

}  // namespace

Value controls_to_json(const Reader& reader) {
  Value list = Value::array();
  for (const nc::AxisTable* control : nc::axis_table_table())
    list.push(localised_result(control_to_json(*control), ResultKind::control, reader));
  return list;
}

Value to_json(std::span<const ListedCompensation> listed, const Reader& reader) {
  Value object = Value::object();
  Value& rows = object.add("compensations", Value::array());
  for (const ListedCompensation& line : listed) rows.push(head_value(line, reader));
  return object;
}

Value to_json(const MadeCompensation& made, const Reader& reader) {
  Value object = Value::object();
  object.add("result", localised_result(made.result, ResultKind::compensation, reader));
  object.add("file_name", made.file_name);
  object.add("table", made.table);
  return object;
}

Value to_json(const KeptCompensation& kept, const Reader& reader) {
  const Versioned<CompensationRecord>& compensation = kept.head.compensation;
  const CompensationRecord& c = compensation.value;
  const store::KeptFile* table = file_of(c.files, "table");
  Value object = head_value(kept.head, reader);
  object.add("change", to_json(compensation.change));
  object.add("program", c.program);
  object.add("options", object_of_text(c.options));
  object.add("findings", counting_value(kept.findings, reader));
  object.add("result", localised_result(kept.result, ResultKind::compensation, reader));
  object.add("table", kept.table);
  object.add("table_sha256", table == nullptr ? std::string() : table->content);
  object.add("existing", existing_value(c));
  object.add("versions", table_versions_value(kept.versions));
  return object;
}

Result<Value> read_table_to_json(const nc::AxisTable& control, const nc::AxisTableOptions& options,
                                 std::string_view text) {
  AXIOMETRY_TRY(const AxisCorrection correction, nc::read_table(control, text, options));
  Value object = Value::object();
  object.add("control", control.id);
  object.add("kind", axis_kind_name(correction.kind()));
  object.add("unit", deviation_unit_key(correction.kind()));
  object.add("table", nodes_to_json(correction));
  return object;
}

Result<CompensationRevision> compensation_revision_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "revision"));
  CompensationRevision revision;
  AXIOMETRY_TRY(RevisionHead head, revision_head(members));
  revision.base_version = head.base_version;
  revision.reason = std::move(head.reason);
  AXIOMETRY_TRY_VOID(take_id(members, value, "retest", revision.retest));
  AXIOMETRY_TRY_VOID(take_given(members, "notes", revision.notes, &given_text));
  AXIOMETRY_TRY_VOID(members.finish());
  return revision;
}

}  // namespace axiometry::app
