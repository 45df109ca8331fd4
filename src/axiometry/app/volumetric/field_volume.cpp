// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/field_volume.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/app/files/source.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/report/volumetric.h"
#include "axiometry/volumetric/field/field_rows.h"

namespace axiometry::app {
namespace {

using formats::vector_value;
using json::Value;
using volumetric::FieldSizes;
using volumetric::PredictedLine;
using volumetric::ToolField;

Value tool_value(const FieldVolume& volume, const ToolField& field) {
  Value value = Value::object();
  value.add("tool", volume.model.machine().tools[field.tool].name);
  value.add("as_found", sizes_value(field.statistics.as_found));
  Value& rigid = value.add("without_rigid_motion", sizes_value(field.statistics.without_rigid_motion));
  if (field.statistics.without_rigid_motion) {
    rigid.add("translation_um", vector_value(field.statistics.translation_um));
    rigid.add("rotation_urad", vector_value(field.statistics.rotation_urad));
  }
  Value& diagonals = value.add("diagonals", Value::object());
  for (const volumetric::DiagonalOfTool& diagonal : field.diagonals)
    diagonals.add(diagonal.name, diagonal.predicted ? line_value(*diagonal.predicted) : Value());
  return value;
}

std::size_t untold(const FieldVolume& volume) {
  std::size_t count = 0;
  for (const ToolField& field : volume.fields)
    if (!field.statistics.as_found || !field.statistics.without_rigid_motion) ++count;
  return count;
}

}  // namespace

Value sizes_value(const std::optional<FieldSizes>& sizes) {
  if (!sizes) return {};
  Value value = Value::object();
  value.add("largest_um", sizes->largest.value);
  value.add("largest_u_um", sizes->largest.u);
  value.add("largest_at_mm", vector_value(sizes->largest_at_mm));
  value.add("mean_um", sizes->mean);
  value.add("percent_95_um", sizes->percent_95);
  return value;
}

Value line_value(const PredictedLine& line) {
  Value value = Value::object();
  value.add("from_mm", vector_value(line.line.from_mm));
  value.add("to_mm", vector_value(line.line.to_mm));
  value.add("systematic_um", line.systematic.value);
  value.add("systematic_u_um", line.systematic.u);
  value.add("slope_um_per_m", line.slope_um_per_m.value);
  value.add("slope_u_um_per_m", line.slope_um_per_m.u);
  value.add("reversal_um", line.has_directions ? Value(line.reversal_um) : Value());
  Value& targets = value.add("targets", Value::array());
  for (std::size_t k = 0; k < line.up.size(); ++k) {
    Value& item = targets.push(Value::object());
    item.add("position_mm", line.line.positions_mm[k]);
    item.add("up_um", line.up[k].value);
    item.add("up_u_um", line.up[k].u);
    item.add("down_um", line.down[k].value);
    item.add("down_u_um", line.down[k].u);
  }
  return value;
}

Result<FieldVolume> field_volume(const FieldVolumeRequest& request) {
  AXIOMETRY_TRY(KeptModel kept, kept_model(request.result));
  return field_volume(std::move(kept), request);
}

FieldVolume field_volume(KeptModel kept, const FieldVolumeRequest& request) {
  FieldVolume volume = field_volume(std::move(kept.model), request);
  put_first(kept.against, volume.findings);
  volume.result_sha256 = std::move(kept.sha256);
  return volume;
}

FieldVolume field_volume(volumetric::ErrorModel model, const FieldVolumeRequest& request) {
  std::vector<ToolField> fields = volumetric::tool_fields(model, request.nodes);
  FieldVolume volume{request, std::move(model), std::move(fields), {}};
  if (const std::size_t count = untold(volume); count > 0)
    volume.findings.push_back({"volumetric-unseen-errors", true,
                               fmt::format("with {} of {} tools the readings do not tell the error of the tool point, "
                                           "and no number is given for it",
                                           count, volume.fields.size())});
  return volume;
}

Value json_of(const FieldVolume& volume) {
  Value root = Value::object();
  root.add("nodes", volume.request.nodes);
  Value& observed = root.add("observed_mm", Value::object());
  observed.add("lowest", vector_value(volume.model.observed().lowest_mm));
  observed.add("highest", vector_value(volume.model.observed().highest_mm));
  Value& tools = root.add("tools", Value::array());
  for (const ToolField& field : volume.fields) tools.push(tool_value(volume, field));
  root.add("findings", findings_value(volume.findings));
  return root;
}

Experiment present(const FieldVolume& volume, const report::Options& options) {
  return {
      report::compose(
          report::VolumeFieldSubject{
              volume.model, volume.fields, volume.findings, {"Result", volume.request.result, volume.result_sha256}},
          options),
      json_of(volume)};
}

std::string field_csv(const FieldVolume& volume) {
  std::string table = fmt::format("{},dx_um,dy_um,dz_um,ux_um,uy_um,uz_um\n", formats::volume_points_head);
  const std::size_t n = volume.request.nodes;
  const auto share = [&](std::size_t k) { return static_cast<double>(k) / static_cast<double>(n - 1); };
  for (const volumetric::Tool& tool : volume.model.machine().tools)
    for (std::size_t k = 0; k < n * n * n; ++k) {
      const Vector3 q =
          volumetric::place_in(volume.model.observed(), {share(k % n), share(k / n % n), share(k / n / n)});
      const volumetric::ToolPointError value = volume.model.at(q, tool.offset_mm);
      fmt::format_to(std::back_inserter(table), "{},{},{},{}", formats::name_cell(text::no_formula(tool.name)),
                     format_exact(q.x), format_exact(q.y), format_exact(q.z));
      for (const auto& error : value.error_um) table += error ? fmt::format(",{:.4f}", *error) : std::string(",");
      for (std::size_t a = 0; a < 3; ++a)
        table += value.error_um[a] ? fmt::format(",{:.4f}", std::sqrt(value.covariance_um2[a][a])) : std::string(",");
      table += '\n';
    }
  return table;
}

}  // namespace axiometry::app
