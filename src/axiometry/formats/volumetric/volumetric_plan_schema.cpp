// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "axiometry/base/reading_limits.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"

namespace axiometry::formats {
namespace {

using json::Value;

Value number_between(double lowest, double highest, std::string_view description) {
  return object({{"type", "number"}, {"minimum", lowest}, {"maximum", highest}, {"description", description}});
}

Value vector_schema(std::string_view description) {
  return object({{"type", "array"},
                 {"items", object({{"type", "number"}, {"minimum", -largest_stated}, {"maximum", largest_stated}})},
                 {"minItems", 3},
                 {"maxItems", 3},
                 {"description", description}});
}

Value places_by_name(std::string_view description) {
  return object(
      {{"type", "object"}, {"additionalProperties", vector_schema("X, Y, Z, mm.")}, {"description", description}});
}

Value range_of_axis() {
  return object({{"type", "array"}, {"items", object({{"type", "number"}})}, {"minItems", 2}, {"maxItems", 2}});
}

Value machine_of_plan() {
  Value axes = object({{"X", range_of_axis()}, {"Y", range_of_axis()}, {"Z", range_of_axis()}});
  return object(
      {{"type", "object"},
       {"properties",
        object({{"chain", object({{"type", "string"}, {"description", "From the workpiece to the tool: XFYZ."}})},
                {"travel_mm", object({{"type", "object"},
                                      {"properties", std::move(axes)},
                                      {"required", Value::array({"X", "Y", "Z"})},
                                      {"additionalProperties", false},
                                      {"description", "Where the axes may stand."}})},
                {"tools_mm", places_by_name("From where the axes stand to the centre of the reflector.")},
                {"stations_mm", places_by_name("Where the instrument stands, in the reflector's coordinates.")}})},
       {"required", Value::array({"chain", "travel_mm", "tools_mm", "stations_mm"})},
       {"description", "As machine.json of 'axiometry volumetric identify', with the stations."}});
}

Value stop_schema() {
  return object(
      {{"type", "object"},
       {"properties",
        object({{"at_mm", vector_schema("Where the axes stand when a length is read.")},
                {"over_mm", object({{"type", "array"},
                                    {"items", vector_schema("Where the axes are driven before.")},
                                    {"description", "In order, from the stop before; straight when absent."}})},
                {"beam_kept", object({{"type", "boolean"},
                                      {"description", "Whether the beam is kept on the way to it (true)."}})}})},
       {"required", Value::array({"at_mm"})},
       {"additionalProperties", false}});
}

}  // namespace

Value volumetric_plan_schema() {
  const Value tracking = tracking_plan_schema();
  const Value& setup = *tracking.find("properties")->find("setup")->find("properties");
  Value run = object(
      {{"type", "object"},
       {"properties", object({{"station", object({{"type", "string"}, {"description", "Name of a station."}})},
                              {"tool", object({{"type", "string"}, {"description", "Name of a tool."}})},
                              {"stops", object({{"type", "array"},
                                                {"items", stop_schema()},
                                                {"description", "In the order in which they are driven to."}})}})},
       {"required", Value::array({"station", "tool", "stops"})},
       {"additionalProperties", false}});
  const auto text = [](std::string_view description) {
    return object({{"type", "string"}, {"description", description}});
  };
  return object(
      {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
       {"$id", "urn:axiometry:schema:axiometry-volumetric-plan:1"},
       {"title", "Axiometry plan of a volumetric calibration"},
       {"description",
        "Where the instrument stands in turn, and with each station and tool the places at which a length is read: "
        "what 'axiometry volumetric plan' writes, and 'nc' and 'volumetric simulate' read."},
       {"type", "object"},
       {"properties",
        object({{"$schema", text("Of this file.")},
                {"format", object({{"const", volumetric_plan_format_name}})},
                {"date", text("On which it was made, as 2026-11-21.")},
                {"machine", machine_of_plan()},
                {"limits", *setup.find("limits")},
                {"obstacles", *setup.find("obstacles")},
                {"feed_mm_per_min", number_between(0.0, 1e6, "Between stops.")},
                {"dwell_s", number_between(0.0, 3600.0, "At rest on every stop.")},
                {"runs", object({{"type", "array"},
                                 {"items", std::move(run)},
                                 {"minItems", 1},
                                 {"description", "One for each station and tool, in the order of measurement."}})},
                {"program", text("That wrote it.")},
                {"version", text("Of that program.")}})},
       {"required", Value::array({"format", "machine", "runs"})},
       {"additionalProperties", false}});
}

}  // namespace axiometry::formats
