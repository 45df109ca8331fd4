// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/test/test_schema.h"

namespace axiometry::formats {
namespace {

using json::Value;

Value whole_number(int minimum, int maximum, std::string_view description) {
  return object({{"type", "integer"}, {"minimum", minimum}, {"maximum", maximum}, {"description", description}});
}

Value number(double minimum, double maximum, std::string_view description) {
  return object({{"type", "number"}, {"minimum", minimum}, {"maximum", maximum}, {"description", description}});
}

Value axis() {
  const Value group = metadata_group_schema("axis");
  Value schema = Value::object();
  for (const auto& [name, value] : group.members()) schema.add(name, name == "type" ? Value("object") : value);
  schema.add("required", Value::array({"kind"}));
  return schema;
}

Value approach() {
  Value parts =
      Value::array({object({{"type", "integer"}, {"minimum", 1}}), object({{"enum", Value::array({"up", "down"})}}),
                    object({{"type", "integer"}, {"minimum", 1}})});
  return object({{"type", "array"},
                 {"prefixItems", std::move(parts)},
                 {"items", false},
                 {"minItems", 3},
                 {"description", "Target by its place in targets (from 1), direction, run (from 1)."}});
}

Value errors() {
  Value name = object({{"type", "string"}, {"pattern", "^[Ee][A-CX-Za-cx-z][X-Zx-z]$"}});
  return object({{"type", or_null("array")},
                 {"items", std::move(name)},
                 {"uniqueItems", true},
                 {"description",
                  "What is to be read at each stop, by the names of ISO 230-1: EYX is the straightness of X in the "
                  "direction of Y, EAX its roll, EXX its positions. Absent or empty: the positions alone."}});
}

Value way(std::string_view description) {
  Value coordinate = object({{"type", "number"}, {"minimum", -1e9}, {"maximum", 1e9}});
  Value point = object({{"type", "array"}, {"items", std::move(coordinate)}, {"minItems", 3}, {"maxItems", 3}});
  return object({{"type", or_null("array")}, {"items", std::move(point)}, {"description", description}});
}

Value finding() {
  return object(
      {{"type", "object"},
       {"properties", object({{"id", object({{"type", "string"}, {"description", "Stable."}})},
                              {"clause", object({{"type", "string"}})},
                              {"severity", object({{"enum", Value::array({"departure", "missing", "note"})}})},
                              {"message", object({{"type", "string"}})}})},
       {"required", Value::array({"clause", "severity", "message"})},
       {"additionalProperties", false}});
}

Value further() {
  Value none_of_its_own = object({{"properties", object({{"further", object({{"type", "null"}})}})}});
  return object({{"type", or_null("array")},
                 {"items", object({{"$ref", "#"}, {"allOf", Value::array({std::move(none_of_its_own)})}})},
                 {"description", "Tests that belong to this one (5.3.3, 5.3.5); one level only."}});
}

Value properties() {
  const Value cycles = Value::array({"standard", "step", "pilgrim", "unidirectional", "user-defined"});
  return object({
      {"$schema", text_schema("For editors; ignored.")},
      {"format", object({{"enum", Value::array({"axiometry-plan/1", Value()})}})},
      {"standard",
       text_schema("Standard whose terms the plan uses: ISO 230-2:2014, or ISO 230-6:2002 along a diagonal.")},
      {"clause",
       text_schema("Clause that describes the test: 5.3.2 to 5.3.5, Annex B or Annex C; absent when none does.")},
      {"rule",
       text_schema("Another rule whose cycle the plan keeps to as well, by the name that `plan --standard` takes.")},
      {"title", text_schema("Which test of several this is.")},
      {"machine", text_schema("Name of the machine, for the printed sheet and for comments in part programs.")},
      {"date", text_schema("Date on which the plan was made, ISO 8601 preferred.")},
      {"axis", axis()},
      {"errors", errors()},
      {"cycle", object({{"enum", cycles}, {"description", "Order of the approaches (5.3.2, Annex B)."}})},
      {"targets", object({{"type", "array"},
                          {"items", object({{"type", "number"}, {"minimum", -1e9}, {"maximum", 1e9}})},
                          {"minItems", 1},
                          {"uniqueItems", true},
                          {"description", "Target positions (3.4), mm or degrees; in any order, they are sorted."}})},
      {"runs", whole_number(1, 10'000, "Approaches to each target from each direction of the cycle (n).")},
      {"overrun", number(1e-6, 1e9, "Distance beyond a target before the direction changes, mm or degrees.")},
      {"feed", number(1e-6, 1e9, "Feed speed between targets, mm/min or degrees/min.")},
      {"acceleration",
       object({{"type", or_null("number")},
               {"minimum", 0.001},
               {"maximum", 1e6},
               {"description",
                "Of the axis, mm/s² or degrees/s², on which durations rest; absent or null: 1000, or 500 of a rotary "
                "one."}})},
      {"dwell_s", number(0, 1e6, "Time at rest on every target, seconds.")},
      {"warm_up_runs", whole_number(0, 10'000, "Movements there and back before the first reading.")},
      {"seed", object({{"type", Value::array({"integer", "string", "null"})},
                       {"minimum", 0},
                       {"exclusiveMaximum", 9007199254740992.0},
                       {"pattern", "^[0-9]+$"},
                       {"description", "Of the random part of the targets; from 2^53 on as a string."}})},
      {"way_in_mm", way("Where X, Y and Z are driven before the first move on a line in space, points in order.")},
      {"way_out_mm", way("Where X, Y and Z are driven after the last move on a line in space.")},
      {"sequence", object({{"type", or_null("array")},
                           {"items", approach()},
                           {"description", "The approaches of the user-defined cycle, in their order."}})},
      {"further", further()},
      {"findings", object({{"type", or_null("array")},
                           {"items", finding()},
                           {"description", "What the program says about the plan; ignored when it is read."}})},
      {"duration_s",
       object({{"type", or_null("number")}, {"description", "Estimated duration, seconds; ignored when it is read."}})},
      {"request",
       object({{"type", or_null("object")}, {"description", "What was asked for; ignored when it is read."}})},
  });
}

}  // namespace

Value plan_schema() {
  return object(
      {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
       {"$id", "urn:axiometry:schema:axiometry-plan:1"},
       {"title", "Axiometry plan"},
       {"description", "A test programme of one machine tool axis: what shall be measured, and in which order."},
       {"type", "object"},
       {"properties", properties()},
       {"required", Value::array({"axis", "cycle", "targets", "runs", "overrun", "feed", "dwell_s"})},
       {"additionalProperties", false}});
}

}  // namespace axiometry::formats
