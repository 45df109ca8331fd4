// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/field_points.h"

#include <fmt/format.h>

#include <vector>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/volumetric/identify/identification.h"

namespace axiometry::app {

using json::Value;
using volumetric::ErrorModel;
using volumetric::ToolPointError;

Result<void> check_inside(const ErrorModel& model, std::size_t axis, double position_mm) {
  constexpr double slack_mm = 0.01;
  const volumetric::CurveBasis& basis = model.coefficients().basis(axis);
  if (position_mm >= basis.lower_mm() - slack_mm && position_mm <= basis.upper_mm() + slack_mm) return {};
  return fail(fmt::format("found {} at {} mm, expected it from {} to {} mm, where the errors are known", "XYZ"[axis],
                          format_exact(position_mm), format_exact(basis.lower_mm()), format_exact(basis.upper_mm())));
}

Result<void> check_inside(const ErrorModel& model, const Vector3& axes_mm) {
  for (std::size_t a = 0; a < volumetric::axis_count; ++a) AXIOMETRY_TRY_VOID(check_inside(model, a, axes_mm[a]));
  return {};
}

namespace {

Result<Vector3> tool_at(const ErrorModel& model, const formats::VolumePoint& point) {
  const auto tool = tool_of_model(model, point.tool);
  if (!tool) return fail(tool.error().message, {point.line, 0});
  return model.machine().tools[*tool].offset_mm;
}

}  // namespace

Result<FieldAtPoints> field_at_points(const FieldRequest& request) {
  AXIOMETRY_TRY(KeptModel kept, kept_model(request.result));
  const ErrorModel& model = kept.model;
  AXIOMETRY_TRY(const std::string bytes, whole_file(request.points));
  AXIOMETRY_TRY(const formats::VolumePoints file, in_file(formats::read_volume_points(bytes), request.points));
  Value root = Value::object();
  Value& points = root.add("points", Value::array());
  std::size_t incomplete = 0;
  for (const formats::VolumePoint& point : file.points) {
    if (const auto inside = check_inside(model, point.axes_mm); !inside)
      return std::unexpected(Error{inside.error().message, request.points, {point.line, 0}});
    AXIOMETRY_TRY(const Vector3 tool, in_file(tool_at(model, point), request.points));
    const ToolPointError field = model.at(point.axes_mm, tool);
    if (!field.is_whole()) ++incomplete;
    Value& item = points.push(Value::object());
    item.add("tool", point.tool);
    item.add("x_mm", point.axes_mm.x);
    item.add("y_mm", point.axes_mm.y);
    item.add("z_mm", point.axes_mm.z);
    Value& error = item.add("error_um", Value::array());
    for (const auto& component : field.error_um) error.push(component ? Value(*component) : Value());
    Value& covariance = item.add("covariance_um2", Value::array());
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        covariance.push(field.error_um[i] && field.error_um[k] ? Value(field.covariance_um2[i][k]) : Value());
  }
  std::vector<NamedFinding> findings = std::move(kept.against);
  if (incomplete > 0)
    findings.push_back({"volumetric-unseen-errors", true,
                        fmt::format("at {} of {} points the readings do not tell all components, which are left empty",
                                    incomplete, file.points.size())});
  for (const std::string& remark : file.remarks) findings.push_back({"volumetric-passed-over", false, remark});
  root.add("findings", findings_value(findings));
  return FieldAtPoints{std::move(root), std::move(findings)};
}

}  // namespace axiometry::app
