// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/compensate_options.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/app/files/given_members.h"
#include "axiometry/app/files/request_members.h"

namespace axiometry::app {
namespace {

using compensation::Method;
using formats::JsonMembers;
using json::Value;

constexpr WholeNumbers any_count{0, 99'999};

constexpr std::pair<std::string_view, Method> method_words[] = {{"least-squares", Method::least_squares},
                                                                {"interpolation", Method::interpolation}};
constexpr std::pair<std::string_view, AxisKind> kind_words[] = {{"linear", AxisKind::linear},
                                                                {"rotary", AxisKind::rotary}};
constexpr std::pair<std::string_view, std::optional<TableCurves>> curves_words[] = {
    {"both-ways", TableCurves::both_ways}, {"with-backlash", TableCurves::with_backlash}};
constexpr std::pair<std::string_view, compensation::Periodic> periodic_words[] = {
    {"keep", compensation::Periodic::keep}, {"leave", compensation::Periodic::leave}};
constexpr std::pair<std::string_view, std::optional<bool>> unit_words[] = {{"mm", false}, {"inch", true}};

Result<std::string> axis_in(JsonMembers& members, const std::string& otherwise) {
  std::optional<std::string> axis;
  AXIOMETRY_TRY_VOID(take_given(members, "axis", axis, &given_line));
  return axis.value_or(otherwise);
}

Result<void> take_count(JsonMembers& members, std::string_view name, unsigned& target) {
  AXIOMETRY_TRY(const auto count, whole_member(members, name, any_count));
  if (count) target = static_cast<unsigned>(*count);
  return {};
}

/// What stands in a table beside its values.
Result<void> take_table_options(JsonMembers& members, nc::AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(take_switch(members, "inch", options.in_inch));
  AXIOMETRY_TRY_VOID(take_count(members, "number", options.number));
  AXIOMETRY_TRY_VOID(members.take("reference", options.reference));
  AXIOMETRY_TRY_VOID(members.take("resolution", options.resolution));
  AXIOMETRY_TRY_VOID(take_count(members, "magnification", options.magnification));
  AXIOMETRY_TRY_VOID(take_count(members, "largest", options.largest));
  AXIOMETRY_TRY_VOID(take_switch(members, "turned_sign", options.turned_sign));
  return members.take("steps_per_unit", options.steps_per_unit);
}

Result<void> take_grid(JsonMembers& members, compensation::GridRequest& grid) {
  AXIOMETRY_TRY_VOID(take_number(members, "start", grid.start));
  AXIOMETRY_TRY_VOID(take_number(members, "end", grid.end));
  AXIOMETRY_TRY_VOID(take_number(members, "step", grid.step));
  AXIOMETRY_TRY(const auto points, whole_member(members, "points", {1, double{AxisCorrection::nodes_max}}));
  if (points) grid.points = static_cast<std::size_t>(*points);
  return {};
}

}  // namespace

Result<CompensateRequest> compensate_request_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "options"));
  CompensateRequest request;
  AXIOMETRY_TRY(const Value* control, members.required("control"));
  AXIOMETRY_TRY(request.control, formats::text_in(*control, "control"));
  AXIOMETRY_TRY(request.axis, axis_in(members, ""));
  AXIOMETRY_TRY_VOID(take_grid(members, request.grid));
  AXIOMETRY_TRY_VOID(take_table_options(members, request.table));
  request.resolution_said = value.find("resolution") != nullptr;
  AXIOMETRY_TRY_VOID(take_choice<std::optional<TableCurves>>(members, "curves", curves_words, request.curves));
  AXIOMETRY_TRY_VOID(take_choice<Method>(members, "method", method_words, request.method));
  AXIOMETRY_TRY_VOID(take_switch(members, "smooth", request.smooth));
  AXIOMETRY_TRY_VOID(take_switch(members, "hold_ends", request.hold_ends));
  AXIOMETRY_TRY_VOID(take_choice<compensation::Periodic>(members, "periodic", periodic_words, request.periodic));
  AXIOMETRY_TRY_VOID(take_number(members, "period", request.period));
  AXIOMETRY_TRY_VOID(take_choice<std::optional<bool>>(members, "existing_unit", unit_words, request.existing_in_inch));
  AXIOMETRY_TRY_VOID(members.finish());
  AXIOMETRY_TRY_VOID(check_request(request));
  return request;
}

Value to_json(const CompensateRequest& request) {
  const CompensateRequest usual;
  Value options = Value::object();
  options.add("control", request.control);
  const auto add_unless = [&](std::string_view name, const auto& value, const auto& as_usual) {
    if (value != as_usual) options.add(name, static_cast<double>(value));
  };
  const auto add_given = [&](std::string_view name, const auto& value) {
    if (value) options.add(name, static_cast<double>(*value));
  };
  const auto add_switch = [&](std::string_view name, bool on) {
    if (on) options.add(name, true);
  };
  if (!request.axis.empty()) options.add("axis", request.axis);
  add_given("start", request.grid.start);
  add_given("end", request.grid.end);
  add_given("step", request.grid.step);
  add_given("points", request.grid.points);
  add_switch("inch", request.table.in_inch);
  add_unless("number", request.table.number, usual.table.number);
  add_unless("reference", request.table.reference, usual.table.reference);
  if (request.resolution_said)
    options.add("resolution", request.table.resolution);
  else
    add_unless("resolution", request.table.resolution, usual.table.resolution);
  add_unless("magnification", request.table.magnification, usual.table.magnification);
  add_unless("largest", request.table.largest, usual.table.largest);
  add_unless("steps_per_unit", request.table.steps_per_unit, usual.table.steps_per_unit);
  if (request.curves) options.add("curves", curves_name(*request.curves));
  if (request.method != usual.method) options.add("method", "interpolation");
  add_switch("smooth", request.smooth);
  add_switch("hold_ends", request.hold_ends);
  add_switch("turned_sign", request.table.turned_sign);
  if (request.periodic != usual.periodic) options.add("periodic", "leave");
  add_given("period", request.period);
  if (request.existing_in_inch) options.add("existing_unit", *request.existing_in_inch ? "inch" : "mm");
  return options;
}

Result<nc::AxisTableOptions> table_reading_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "options"));
  nc::AxisTableOptions options;
  options.axis_told = value.find("axis") != nullptr;
  options.resolution_told = value.find("resolution") != nullptr;
  AXIOMETRY_TRY(options.axis, axis_in(members, options.axis));
  AXIOMETRY_TRY_VOID(members.take("step", options.step));
  AXIOMETRY_TRY_VOID(take_table_options(members, options));
  AXIOMETRY_TRY_VOID(take_choice<AxisKind>(members, "kind", kind_words, options.kind));
  AXIOMETRY_TRY_VOID(members.finish());
  AXIOMETRY_TRY_VOID(check_table_options(options));
  return options;
}

}  // namespace axiometry::app
