// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/test/test_schema.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/formats/text/units.h"
#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace {

using json::Value;

Value typed(std::string_view type, std::string_view description) {
  Value schema = object({{"type", type}});
  if (!description.empty()) schema.add("description", description);
  return schema;
}

std::string describe(const Field& field) {
  std::string text = fmt::format("{}. {}", field.title, field.description);
  if (!field.unit_linear.empty() && !field.unit_rotary.empty() && field.unit_linear != field.unit_rotary)
    text += fmt::format(" Unit {}; {} on a rotary axis.", field.unit_linear, field.unit_rotary);
  else if (!field.unit_linear.empty())
    text += fmt::format(" Unit {}.{}", field.unit_linear, field.unit_rotary.empty() ? " Linear axes only." : "");
  if (!field.clause.empty()) text += fmt::format(" ISO 230-2:2014, {}.", field.clause);
  return text;
}

void add_range(Value& schema, const Field& field) {
  schema.add("minimum", field.minimum);
  schema.add("maximum", field.maximum);
}

Value record_schema(const Field& field) {
  Value properties = Value::object();
  for (const RecordColumn& column : field.columns) {
    Value property = object({{"type", or_null(column.type == FieldType::number ? "number" : "string")}});
    property.add("description", column.unit.empty() ? fmt::format("{}.", column.title)
                                                    : fmt::format("{}. Unit {}.", column.title, column.unit));
    properties.add(column.key, std::move(property));
  }
  return object({{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}});
}

Value field_schema(const Field& field) {
  Value schema = Value::object();
  switch (field.type) {
    case FieldType::text: schema.add("type", or_null("string")); break;
    case FieldType::boolean: schema.add("type", or_null("boolean")); break;
    case FieldType::number:
      schema.add("type", or_null("number"));
      add_range(schema, field);
      break;
    case FieldType::choice: {
      Value& words = schema.add("enum", Value::array());
      for (std::string_view word : field.choices) words.push(word);
      words.push(Value());
      break;
    }
    case FieldType::numbers:
      schema.add("type", or_null("array"));
      add_range(schema.add("items", object({{"type", "number"}})), field);
      break;
    case FieldType::records:
      schema.add("type", or_null("array"));
      schema.add("items", record_schema(field));
      break;
  }
  schema.add("description", describe(field));
  return schema;
}

/// The members of every group, in the order of the table; a group may come in pieces there.
void add_groups(Value& properties) {
  std::vector<std::string_view> done;
  for (const Field& first : metadata_fields()) {
    const std::string_view group = first.key.substr(0, first.key.find('.'));
    if (group == first.key) {
      properties.add(group, field_schema(first));
      continue;
    }
    if (std::ranges::find(done, group) != done.end()) continue;
    done.push_back(group);
    properties.add(group, metadata_group_schema(group));
  }
}

Value unit_names_schema(std::string_view description) {
  Value names = Value::array();
  for (const Unit& unit : units()) names.push(unit.name);
  return object({{"enum", std::move(names)}, {"description", description}});
}

Value runs_schema(std::string_view description) {
  Value run = object({{"type", "array"}, {"items", object({{"type", or_null("number")}})}});
  Value schema = object({{"type", or_null("array")}, {"items", std::move(run)}, {"description", description}});
  return schema;
}

Value series_schema() {
  Value properties = object({
      {"quantity",
       object({{"enum", Value::array({"deviation", "position"})},
               {"default", "deviation"},
               {"description", "What the readings are: deviations (actual minus target) or measured positions."}})},
      {"unit", unit_names_schema("Unit of the readings.")},
      {"target_unit",
       unit_names_schema("Unit of the targets: a length when that of the readings is one, else an angle.")},
      {"targets", object({{"type", "array"},
                          {"items", object({{"type", "number"}})},
                          {"minItems", 2},
                          {"uniqueItems", true},
                          {"description", "Every target position once, in any order."}})},
      {"up", runs_schema("Approaches in the positive direction: one list per run, one reading per target in the order "
                         "of targets, null where it is missing.")},
      {"down", runs_schema("Approaches in the negative direction, likewise in the order of targets.")},
  });
  Value either =
      Value::array({object({{"required", Value::array({"up"})}}), object({{"required", Value::array({"down"})}})});
  return object({{"type", "object"},
                 {"description", "The readings."},
                 {"properties", std::move(properties)},
                 {"required", Value::array({"unit", "target_unit", "targets"})},
                 {"anyOf", std::move(either)},
                 {"additionalProperties", false}});
}

Value times_schema() {
  Value properties = object({{"up", runs_schema("Of the approaches in the positive direction.")},
                             {"down", runs_schema("Of the approaches in the negative direction.")}});
  return object({{"type", or_null("object")},
                 {"description",
                  "When each reading was taken, in seconds since some beginning: in the shape of the runs "
                  "of the series, null where it is not known."},
                 {"properties", std::move(properties)},
                 {"additionalProperties", false}});
}

Value source_schema() {
  Value properties = object({{"file", typed("string", "Its name.")},
                             {"sha256", typed("string", "Of its bytes, hexadecimal.")},
                             {"format", typed("string", "The format it was read as.")},
                             {"remarks", object({{"type", "array"},
                                                 {"description", "What was guessed or left out when it was read."},
                                                 {"items", object({{"type", "string"}})}})},
                             {"departures", object({{"type", "array"},
                                                    {"description", "Why a test from it is no test after ISO 230-2."},
                                                    {"items", object({{"type", "string"}})}})},
                             {"swapped_labels", typed("boolean",
                                                      "The targets run the other way than the labels of "
                                                      "direction say.")}});
  return object({{"type", or_null("object")},
                 {"description", "The file or stream that this one was taken from."},
                 {"properties", std::move(properties)},
                 {"required", Value::array({"file", "sha256", "format"})},
                 {"additionalProperties", false}});
}

}  // namespace

Value object(std::initializer_list<std::pair<std::string_view, Value>> members) {
  Value result = Value::object();
  for (const auto& [name, value] : members) result.add(name, value);
  return result;
}

Value or_null(std::string_view type) { return Value::array({type, "null"}); }

Value text_schema(std::string_view description) {
  return object({{"type", or_null("string")}, {"description", description}});
}

Value metadata_group_schema(std::string_view group) {
  Value members = Value::object();
  for (const Field& field : metadata_fields())
    if (field.key.starts_with(fmt::format("{}.", group)))
      members.add(field.key.substr(group.size() + 1), field_schema(field));
  return object({{"type", or_null("object")}, {"properties", std::move(members)}, {"additionalProperties", false}});
}

std::string test_schema() {
  Value properties = Value::object();
  properties.add("$schema", typed("string", "For editors; ignored."));
  properties.add("format", object({{"const", test_format_name}}));
  properties.add("source", source_schema());
  add_groups(properties);
  properties.add("series", series_schema());
  properties.add("times_s", times_schema());
  const Value schema =
      object({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"$id", "urn:axiometry:schema:axiometry-test:1"},
              {"title", "Axiometry test"},
              {"description", "A positioning test of one machine tool axis: what was tested, how, and the readings."},
              {"type", "object"},
              {"properties", std::move(properties)},
              {"required", Value::array({"format", "series"})},
              {"additionalProperties", false}});
  return json::dump(schema) + "\n";
}

}  // namespace axiometry::formats
