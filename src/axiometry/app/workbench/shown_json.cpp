// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/shown_json.h"

#include "axiometry/app/workbench/kept_assessment.h"
#include "axiometry/report/report.h"

namespace axiometry::app {
namespace {

using json::Kind;
using json::Value;

Value copy_or_null(const Value* value) { return value == nullptr ? Value() : *value; }

const Value* judgement_on(const Value& result, std::string_view parameter) {
  const Value* tolerances = member_of_object(result, "tolerances");
  if (tolerances == nullptr || !tolerances->is(Kind::array)) return nullptr;
  for (const Value& row : tolerances->items()) {
    const Value* key = member_of_object(row, "parameter");
    if (key != nullptr && key->is(Kind::text) && key->text() == parameter) return &row;
  }
  return nullptr;
}

}  // namespace

const json::Value* member_of_object(const json::Value& object, std::string_view name) {
  return object.is(Kind::object) ? object.find(name) : nullptr;
}

json::Value verdict_or_null(const Value* verdict) {
  return verdict != nullptr && verdict->is(Kind::text) && verdict->text() != "not applicable" ? *verdict : Value();
}

json::Value shown_to_json(const Value& result, const Reader& reader) {
  const iso230_2::Assessment assessment = assessment_shown_by(result);
  const AxisKind kind = axis_kind_of(result);
  report::Options options;
  options.numbers = reader.numbers;
  Value list = Value::array();
  for (const auto& parameter : iso230_2::parameters) {
    const report::ShownParameter shown = report::show(parameter, assessment, kind, options);
    const bool exists = (assessment.evaluation.parameters.*parameter.member).has_value();
    Value& row = list.push(Value::object());
    row.add("parameter", parameter.key);
    row.add("value", exists ? shown.value : language::translated(shown.value, reader.language));
    row.add("U", shown.U);
    row.add("interval", shown.interval.empty() ? "" : language::translated(shown.interval, reader.language));
    row.add("unit", shown.unit);
    const Value* judgement = judgement_on(result, parameter.key);
    row.add("limit", judgement == nullptr ? Value() : copy_or_null(member_of_object(*judgement, "limit")));
    row.add("verdict", judgement == nullptr ? Value() : verdict_or_null(member_of_object(*judgement, "verdict")));
    const auto known = iso230_2::uncertainty_of_record(assessment, parameter);
    row.add("low", known ? Value(known->interval.lower) : Value());
    row.add("high", known ? Value(known->interval.upper) : Value());
    row.add("method", known ? Value(iso230_2::method_key(known->method)) : Value());
    for (const std::string_view member : {"source", "replaced"})
      row.add(member, judgement == nullptr ? Value() : copy_or_null(member_of_object(*judgement, member)));
    const Value* withheld = judgement == nullptr ? nullptr : member_of_object(*judgement, "withheld");
    row.add("withheld", withheld != nullptr && withheld->is(Kind::text)
                            ? Value(language::translated(withheld->text(), reader.language, reader.numbers))
                            : Value());
  }
  return list;
}

}  // namespace axiometry::app
