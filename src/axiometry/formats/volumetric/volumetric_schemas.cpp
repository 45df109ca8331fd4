// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"
#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::formats {
namespace {

using json::Value;

Value number(std::string_view description) { return object({{"type", "number"}, {"description", description}}); }
Value number_or_null(std::string_view description) {
  return object({{"type", or_null("number")}, {"description", description}});
}
Value not_negative(std::string_view description) {
  return object({{"type", "number"}, {"minimum", 0}, {"description", description}});
}
Value text(std::string_view description) { return object({{"type", "string"}, {"description", description}}); }
Value list_of(Value items, std::string_view description) {
  return object({{"type", "array"}, {"items", std::move(items)}, {"description", description}});
}
Value numbers(std::size_t count, std::string_view description) {
  return object({{"type", "array"},
                 {"items", object({{"type", "number"}})},
                 {"minItems", count},
                 {"maxItems", count},
                 {"description", description}});
}
/// Members X, Y, Z.
Value per_axis(const Value& each, std::string_view description) {
  return object({{"type", "object"},
                 {"properties", object({{"X", each}, {"Y", each}, {"Z", each}})},
                 {"required", Value::array({"X", "Y", "Z"})},
                 {"description", description}});
}
Value named_places(std::string_view description, bool has_least) {
  Value places = object(
      {{"type", "object"}, {"additionalProperties", numbers(3, "X, Y, Z in mm.")}, {"description", description}});
  if (has_least) places.add("minProperties", 1);
  return places;
}

Value machine_properties() {
  return object(
      {{"$schema", text("This schema, where one names it.")},
       {"name", text("What the machine is called.")},
       {"chain", object({{"type", "string"},
                         {"pattern", "^w?[XYZFb]{4}t?$"},
                         {"description",
                          "X, Y, Z and F (or b) for the foundation once each: axes before it carry the "
                          "workpiece, those behind it the tool, from the workpiece to the tool."}})},
       {"travel_mm", per_axis(numbers(2, "The two ends, the lower one first."), "Where the axes can stand.")},
       {"tools_mm", named_places("From where the axes stand to the centre of the reflector, for each tool.", true)},
       {"stations_mm", named_places("Where the instrument is planned or said to stand.", false)},
       {"instrument",
        object(
            {{"type", "object"},
             {"properties",
              object({{"a_um", not_negative("a of U = a + b·L (k = 2), of one length independent of others.")},
                      {"b_um_per_m", not_negative("b likewise.")},
                      {"scale_u_um_per_m", not_negative("Standard uncertainty of what all lengths have in common, as "
                                                        "the wavelength of air.")}})}})},
       {"repeatability_um", not_negative("Of the machine at a stop, standard deviation along the beam.")},
       {"functional_point_mm",
        object({{"type", "object"},
                {"properties", object({{"X", numbers(3, "X, Y, Z in mm.")},
                                       {"Y", numbers(3, "X, Y, Z in mm.")},
                                       {"Z", numbers(3, "X, Y, Z in mm.")}})},
                {"description", "Where the error motions of an axis are stated; the machine's zero by default."}})}});
}

Value estimate(std::string_view unit) {
  return object(
      {{"type", "object"},
       {"properties", object({{"value", number_or_null(unit)}, {"u", number_or_null("Standard uncertainty.")}})},
       {"required", Value::array({"value", "u"})}});
}

Value errors() {
  Value properties = Value::object();
  Value required = Value::array();
  const auto names = volumetric::error_names();
  const std::size_t motions = volumetric::axis_count * volumetric::motion_count;
  for (std::size_t e = 0; e < names.size(); ++e) {
    required.push(names[e]);
    const bool is_angle = e >= motions || volumetric::error_motion_named(names[e])->is_rotation();
    const std::string_view unit = is_angle ? "In µrad." : "In µm.";
    if (e >= motions) {
      properties.add(names[e], estimate(unit));
      continue;
    }
    Value node = object({{"type", "object"},
                         {"properties", object({{"position", number("Of the axis, mm.")},
                                                {"value", number(unit)},
                                                {"u", number("Standard uncertainty.")},
                                                {"up", estimate(unit)},
                                                {"down", estimate(unit)}})},
                         {"required", Value::array({"position", "value", "u"})}});
    properties.add(names[e], list_of(std::move(node), "Empty where the lengths do not tell it."));
  }
  return object({{"type", "object"}, {"properties", std::move(properties)}, {"required", std::move(required)}});
}

Value finding() {
  return object({{"type", "object"},
                 {"properties", object({{"id", text("Stable.")},
                                        {"severity", object({{"enum", Value::array({"serious", "note"})}})},
                                        {"message", text("A sentence without full stop.")}})},
                 {"required", Value::array({"id", "severity", "message"})}});
}

}  // namespace

Value machine_schema() {
  return object({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"$id", "urn:axiometry:schema:axiometry-machine:1"},
                 {"title", "Axiometry machine"},
                 {"description",
                  "A machine of three linear axes, its tools and the instrument of a volumetric "
                  "calibration; what 'axiometry volumetric --machine' reads. Other members are passed "
                  "over and told."},
                 {"type", "object"},
                 {"properties", machine_properties()},
                 {"required", Value::array({"chain", "travel_mm", "tools_mm"})}});
}

Value volumetric_result_schema() {
  Value station = object({{"type", "object"},
                          {"properties", object({{"station", text("Its name.")},
                                                 {"tool", text("With which it was seen there.")},
                                                 {"position_mm", numbers(3, "Where it stood.")},
                                                 {"readings", number("So many.")},
                                                 {"rms_um", number("Of the residuals.")},
                                                 {"scale_um_per_m", number("How much longer axes were there.")}})},
                          {"required", Value::array({"station", "tool", "position_mm"})}});
  Value model = object(
      {{"type", "object"},
       {"properties", object({{"machine", object({{"type", "object"}, {"properties", machine_properties()}})},
                              {"coefficients", list_of(object({{"type", "number"}}), "µm and µrad.")},
                              {"covariance", list_of(object({{"type", "number"}}), "Lower triangle by rows.")}})},
       {"required", Value::array({"machine", "reversal", "curves", "observed_mm", "coefficients", "covariance"})}});
  return object(
      {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
       {"$id", "urn:axiometry:schema:axiometry-volumetric-result:1"},
       {"title", "Axiometry volumetric result"},
       {"description",
        "The 21 errors of a machine: what 'axiometry volumetric identify' writes. Of it field, export and "
        "predictions read the member model."},
       {"type", "object"},
       {"properties",
        object({{"errors", errors()},
                {"gauge", object({{"type", "object"}})},
                {"rank", object({{"type", "object"},
                                 {"properties", object({{"unknowns", number("Under the gauge.")},
                                                        {"errors", number("Of these, of errors.")},
                                                        {"rank", number("Directions that the lengths tell.")},
                                                        {"null_directions", number("Those that they do not.")},
                                                        {"condition", number("Of the scaled rows.")}})},
                                 {"required", Value::array({"unknowns", "rank", "null_directions", "condition"})}})},
                {"unseen", list_of(object({{"type", "string"}}), "Errors that have no number.")},
                {"chi2_per_dof", number_or_null("Near 1 where uncertainties are stated right.")},
                {"stations", list_of(std::move(station), "For each station and tool.")},
                {"smoothness", object({{"type", Value::array({"object", "null"})},
                                       {"description", "What was taken for known of the curves; docs/results.md."}})},
                {"part_scales", object({{"type", Value::array({"object", "null"})},
                                        {"description",
                                         "Parts that differ in scale, as of other temperatures: how far, "
                                         "and whether it is held; docs/results.md."}})},
                {"findings", list_of(finding(), "Serious ones first.")},
                {"model", std::move(model)}})},
       {"required",
        Value::array({"errors", "gauge", "rank", "unseen", "chi2_per_dof", "stations", "findings", "model"})}});
}

}  // namespace axiometry::formats
