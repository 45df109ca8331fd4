// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"
#include "axiometry/volumetric/field/line_prediction.h"

/// The targets of a plan or a test that a calibration is held against.
namespace axiometry::app {

/// What is known of the targets, and of where they lie.
struct TargetsOfFile {
  std::vector<double> positions_mm;
  std::optional<SpatialLine> line;
  std::optional<volumetric::MeasuredMeans> means;
  std::string axis_name;             ///< of a test, as it states it
  std::optional<Vector3> offset_mm;  ///< offset of the tool of a test, as it states it
};

/// Those of a plan, with its line where it states one. Fails on what is no plan.
Result<TargetsOfFile> targets_of_plan(const std::string& file);

/// Targets with a mean in both directions, or in the one that there is. Fails on a test of a rotary axis and of one
/// run.
Result<TargetsOfFile> targets_of_test(const std::string& file);

}  // namespace axiometry::app
