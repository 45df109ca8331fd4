// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/volumetric/field/tool_fields.h"

/// The use case "how large the error of the tool point is over the volume".
namespace axiometry::app {

struct FieldVolumeRequest {
  std::string result;                           ///< file of `axiometry volumetric identify --out`
  std::size_t nodes = volumetric::field_nodes;  ///< nodes along each axis, 2 to 101
};

struct FieldVolume {
  FieldVolumeRequest request;
  volumetric::ErrorModel model;
  std::vector<volumetric::ToolField> fields;
  std::vector<NamedFinding> findings;
  std::string result_sha256 = {};  ///< hash of the file of the result; empty of one that is at hand
};

Result<FieldVolume> field_volume(const FieldVolumeRequest& request);

/// The same of a model that is at hand; request.result is only its name.
FieldVolume field_volume(KeptModel kept, const FieldVolumeRequest& request);
FieldVolume field_volume(volumetric::ErrorModel model, const FieldVolumeRequest& request);

/// Report and JSON; keys: docs/results.md.
Experiment present(const FieldVolume& volume, const report::Options& options);

json::Value json_of(const FieldVolume& volume);

/// {"largest_um", "largest_u_um", "largest_at_mm", "mean_um", "percent_95_um"}, or null.
json::Value sizes_value(const std::optional<volumetric::FieldSizes>& sizes);

/// {"systematic_um", "systematic_u_um", …}: a line as predicted, in every JSON that holds one.
json::Value line_value(const volumetric::PredictedLine& line);

/// Each node of the grid with each tool: `tool,x_mm,y_mm,z_mm,dx_um,dy_um,dz_um,ux_um,uy_um,uz_um`; empty what the
/// lengths do not tell.
std::string field_csv(const FieldVolume& volume);

}  // namespace axiometry::app
