// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/reading_limits.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/tracking/station_json.h"

namespace axiometry::formats {
namespace {

using json::Value;

Value place(std::string_view description) {
  return object({{"type", "array"},
                 {"items", object({{"type", "number"}, {"minimum", -largest_stated}, {"maximum", largest_stated}})},
                 {"minItems", 3},
                 {"maxItems", 3},
                 {"description", description}});
}

Value matrix(std::string_view description) {
  Value row = object({{"type", "array"}, {"items", object({{"type", "number"}})}, {"minItems", 3}, {"maxItems", 3}});
  return object({{"type", or_null("array")},
                 {"items", std::move(row)},
                 {"minItems", 3},
                 {"maxItems", 3},
                 {"description", description}});
}

Value of_kind(std::string_view kind, std::string_view description) {
  return object({{"type", or_null(kind)}, {"description", description}});
}

Value numbers(std::string_view description) {
  return object({{"type", or_null("array")}, {"items", object({{"type", "number"}})}, {"description", description}});
}

/// What both estimators have; members that say how it came about may be more.
Value estimator(std::string_view description, Value station, Value required) {
  return object({{"type", or_null("object")},
                 {"properties",
                  object({{"station", std::move(station)},
                          {"L0", of_kind("number", "Distance at the zero of the lengths, mm.")},
                          {"covariance", matrix("Covariance of the station, mm².")},
                          {"covariance_for_bounds",
                           matrix("The same, as wide as a normal station must have it for bounds that hold 95 %, "
                                  "mm²: read in its place. Results of versions that did not write it are widened by "
                                  "their chi_squared and degrees_of_freedom.")},
                          {"chi_squared", of_kind("number", "Sum of the squared weighted residuals.")},
                          {"degrees_of_freedom", of_kind("integer", "Points less 4.")},
                          {"residuals", numbers("Distance less L0 less length difference of each point, mm.")},
                          {"rank", of_kind("integer", "Of the five columns of eq. 14.")},
                          {"condition", of_kind("number", "Largest over smallest singular value.")}})},
                 {"required", std::move(required)},
                 {"description", description}});
}

Value finding() {
  return object({{"type", "object"},
                 {"properties", object({{"id", object({{"type", "string"}, {"description", "Stable."}})},
                                        {"severity", object({{"enum", Value::array({"serious", "note"})}})},
                                        {"message", object({{"type", "string"}})}})},
                 {"required", Value::array({"severity", "message"})}});
}

Value either(std::string_view member) { return object({{"required", Value::array({Value(member)})}}); }

}  // namespace

Value station_schema() {
  Value unsolved = object({{"anyOf", Value::array({place("Where the instrument stands."),
                                                   object({{"type", "null"}, {"description", "No solution."}})})}});
  return object(
      {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
       {"$id", "urn:axiometry:schema:axiometry-station:1"},
       {"title", "Axiometry station"},
       {"description",
        "Where a tracking interferometer stands: the result of 'axiometry tracking locate', or what people wrote. The "
        "refined station and its covariance are read; other members are passed over."},
       {"type", "object"},
       {"properties",
        object({{"station", place("Where the instrument stands, mm, in the reflector's coordinates.")},
                {"covariance", matrix("Covariance of the station, mm²; absent when nothing is known about it.")},
                {"refined", estimator("Least squares on the lengths.", place("Where the instrument stands, mm."),
                                      Value::array({"station"}))},
                {"linear", estimator("Eq. 14 of Lee et al.; null where it has no unique solution.", std::move(unsolved),
                                     Value::array({"rank", "condition"}))},
                {"misclosure", of_kind("number", "psi − (|s|² − L0²) of eq. 13, mm².")},
                {"findings", object({{"type", "array"}, {"items", finding()}})}})},
       {"anyOf", Value::array({either("refined"), either("station")})}});
}

}  // namespace axiometry::formats
