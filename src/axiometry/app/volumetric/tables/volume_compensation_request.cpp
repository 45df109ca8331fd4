// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/tables/volume_compensation_request.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "axiometry/app/compensate/compensate_options.h"
#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/files/given_members.h"
#include "axiometry/app/files/request_members.h"
#include "axiometry/app/results/localised_result.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;

constexpr std::pair<std::string_view, std::optional<std::size_t>> machine_axes[] = {{"X", 0}, {"Y", 1}, {"Z", 2}};

}  // namespace

Result<VolumeCompensationRequest> volume_compensation_request_from(const Value& body) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(body, "body"));
  for (const std::string_view known : {"model", "findings", "remarks"}) members.pass_over(known);
  VolumeCompensationRequest request;
  AXIOMETRY_TRY(const Value* options, members.required("options"));
  AXIOMETRY_TRY(request.how, compensate_request_from(*options));
  AXIOMETRY_TRY_VOID(members.required("along"));
  std::optional<std::size_t> along, component;
  AXIOMETRY_TRY_VOID(take_choice<std::optional<std::size_t>>(members, "along", machine_axes, along));
  AXIOMETRY_TRY_VOID(take_choice<std::optional<std::size_t>>(members, "component", machine_axes, component));
  request.along = *along;
  request.component = component.value_or(request.along);
  AXIOMETRY_TRY_VOID(members.take("tool", request.tool));
  std::optional<std::string> output_axis;
  AXIOMETRY_TRY_VOID(take_given(members, "output_axis", output_axis, &given_line));
  request.how.table.output_axis = output_axis.value_or("");
  AXIOMETRY_TRY_VOID(members.finish());
  return request;
}

std::string table_file_name(const VolumeCompensation& made) {
  const std::string axis = file_name_part(made.options.axis);
  const bool is_cross = !made.options.output_axis.empty() && made.options.output_axis != made.options.axis;
  return fmt::format("{}-{}{}", is_cross ? file_name_part(made.options.output_axis) + "-by-" + axis : axis,
                     made.control->id, made.control->extension);
}

Value volume_compensation_value(const VolumeCompensation& made, const Reader& reader) {
  Value object = Value::object();
  object.add("file_name", table_file_name(made));
  object.add("table", made.text);
  object.add("result", localised_result(to_json(made), ResultKind::compensation, reader));
  return object;
}

}  // namespace axiometry::app
