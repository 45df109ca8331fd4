// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/reading_limits.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/test/test_schema.h"

namespace axiometry::formats {
namespace {

using json::Value;

Value number_or_null(double minimum, double maximum, std::string_view description) {
  return object(
      {{"type", or_null("number")}, {"minimum", minimum}, {"maximum", maximum}, {"description", description}});
}

Value vector(std::string_view description) {
  return object({{"type", "array"},
                 {"items", object({{"type", "number"}, {"minimum", -largest_stated}, {"maximum", largest_stated}})},
                 {"minItems", 3},
                 {"maxItems", 3},
                 {"description", description}});
}

Value closed(Value properties, Value required, std::string_view description) {
  return object({{"type", "object"},
                 {"properties", std::move(properties)},
                 {"required", std::move(required)},
                 {"additionalProperties", false},
                 {"description", description}});
}

Value list_of(Value items, std::string_view description) {
  return object({{"type", or_null("array")}, {"items", std::move(items)}, {"description", description}});
}

Value box(std::string_view description) {
  return closed(object({{"lowest_mm", vector("Corner with the lowest X, Y, Z.")},
                        {"highest_mm", vector("Corner with the highest X, Y, Z.")}}),
                Value::array({"lowest_mm", "highest_mm"}), description);
}

Value station() {
  Value rows = object({{"type", or_null("array")},
                       {"items", vector("Row of X, Y or Z, mm².")},
                       {"minItems", 3},
                       {"maxItems", 3},
                       {"description", "Covariance of the station; absent when nothing is known about it."}});
  return closed(object({{"position_mm", vector("Where the instrument stands, in the reflector's coordinates.")},
                        {"covariance_mm2", std::move(rows)}}),
                Value::array({"position_mm"}), "The place of the instrument.");
}

Value limits() {
  return closed(object({{"range_least_mm", number_or_null(0, largest_stated, "Shortest distance of the instrument.")},
                        {"range_most_mm", number_or_null(0, largest_stated, "Longest distance of the instrument.")},
                        {"elevation_lowest_deg", number_or_null(-90, 90, "Of the beam above the plane of X and Y.")},
                        {"elevation_highest_deg", number_or_null(-90, 90, "Of the beam above the plane of X and Y.")},
                        {"reflector_axis", vector("Where the reflector looks, from the spindle.")},
                        {"incidence_most_deg", number_or_null(0, 180, "Between the beam and the reflector's axis.")},
                        {"safe_radius_mm",
                         number_or_null(0, largest_stated, "Nothing of the machine comes nearer to the station.")},
                        {"line_least_mm", number_or_null(0, largest_stated, "A shorter line is not worth a test.")}}),
                Value::array(), "What instrument and reflector can do.");
}

Value obstacle() {
  return closed(
      object({{"name", text_schema("What it is.")},
              {"box", box("With edges along X, Y, Z.")},
              {"sphere", closed(object({{"centre_mm", vector("Centre.")},
                                        {"radius_mm", number_or_null(0, largest_stated, "Radius.")}}),
                                Value::array({"centre_mm", "radius_mm"}), "A ball.")},
              {"cylinder", closed(object({{"base_mm", vector("Middle of the lower end.")},
                                          {"radius_mm", number_or_null(0, largest_stated, "Radius.")},
                                          {"height_mm", number_or_null(0, largest_stated, "Height.")}}),
                                  Value::array({"base_mm", "radius_mm", "height_mm"}), "Upright, along Z.")}}),
      Value::array(), "One of box, sphere, cylinder, at rest in the station's coordinates.");
}

Value setup() {
  return closed(
      object({{"travel", box("Where the axes may stand.")},
              {"tool_offset_mm", vector("From where the axes stand to the centre of the reflector.")},
              {"station", station()},
              {"limits", limits()},
              {"ranging", closed(object({{"constant_um", number_or_null(0, largest_stated, "a, in µm.")},
                                         {"per_length_um_per_m", number_or_null(0, largest_stated, "b, in µm/m.")}}),
                                 Value::array(), "Expanded uncertainty (k = 2) of a length L: a + b·L.")},
              {"obstacles", list_of(obstacle(), "What stands in the way of reflector and beam.")}}),
      Value::array({"travel"}),
      "Machine, instrument and what stands about. Without a station: an interferometer that is aligned with "
      "each line in turn.");
}

Value line() {
  return closed(
      object({{"id", object({{"type", "string"}, {"minLength", 1}, {"description", "Such as xy or NNN-PPP."}})},
              {"plan", object({{"$ref", "urn:axiometry:schema:axiometry-plan:1"}})}}),
      Value::array({"id", "plan"}), "A line and its test programme.");
}

Value lost() {
  return closed(object({{"id", text_schema("Of the line.")}, {"reason", text_schema("Why it cannot be measured.")}}),
                Value::array(), "A line that cannot be measured from this station.");
}

Value ignored(std::string_view type) {
  return object({{"type", or_null(type)}, {"description", "For people; ignored when it is read."}});
}

/// The program that wrote the plan, by name and version; older ones wrote a text.
Value program() {
  return object({{"type", Value::array({"object", "string", "null"})},
                 {"description", "Which program wrote the plan; ignored when it is read."}});
}

}  // namespace

Value tracking_plan_schema() {
  return object(
      {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
       {"$id", "urn:axiometry:schema:axiometry-tracking-plan:1"},
       {"title", "Axiometry tracking plan"},
       {"description", "A test of several lines in space with a tracking interferometer."},
       {"type", "object"},
       {"properties", object({{"$schema", text_schema("For editors; ignored.")},
                              {"format", object({{"const", tracking_plan_format_name}})},
                              {"title", text_schema("Which test this is.")},
                              {"machine", text_schema("Name of the machine.")},
                              {"date", text_schema("Date on which the plan was made.")},
                              {"setup", setup()},
                              {"lines", object({{"type", "array"}, {"items", line()}})},
                              {"lost", list_of(lost(), "Lines that cannot be measured from this station.")},
                              {"remarks", list_of(object({{"type", "string"}}), "Of the planner, for people.")},
                              {"program", program()},
                              {"version", ignored("string")},
                              {"duration_s", ignored("number")}})},
       {"required", Value::array({"format", "setup", "lines"})},
       {"additionalProperties", false}});
}

}  // namespace axiometry::formats
