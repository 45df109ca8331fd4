// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/app/volumetric/field_volume.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/field/error_model.h"

/// The use case "what has changed between two results of one machine".
namespace axiometry::app {

/// {"nodes", "observed_mm", "before", "after" (as field_value()), "tools": [{"tool", "offset_mm", "as_found",
/// "without_rigid_motion"}]}: of the tools that both have, by name and offset, over the travel that both were observed
/// in. Fails where that is no volume, and where no tool is the same.
Result<json::Value> field_difference(const KeptModel& before, const KeptModel& after, std::size_t nodes);

/// The JSON of present(FieldVolume) with, for each tool, "error_um": δ at every node, X fastest, null where it is not
/// told.
json::Value field_value(const FieldVolume& volume);

}  // namespace axiometry::app
