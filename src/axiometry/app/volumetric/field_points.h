// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/base/vector3.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/volumetric/field/error_model.h"

/// The use case "what the tool point errs at these places".
namespace axiometry::app {

/// Curves are stated over how far readings reach, or to the ends of the travel that they nearly cover: fails elsewhere,
/// by more than a hundredth of a millimetre.
Result<void> check_inside(const volumetric::ErrorModel& model, const Vector3& axes_mm);
Result<void> check_inside(const volumetric::ErrorModel& model, std::size_t axis, double position_mm);

struct FieldRequest {
  std::string result;  ///< file of `axiometry volumetric identify --out`
  std::string points;  ///< CSV with tool,x_mm,y_mm,z_mm; "-" is the standard input
};

struct FieldAtPoints {
  json::Value value;
  std::vector<NamedFinding> findings;  ///< findings that stand in the result
};

/// {"points": [{tool, x_mm, y_mm, z_mm, error_um, covariance_um2}], "findings"} in the order of the file. A component
/// that the lengths do not tell is null, and its covariances are. Fails, with file and line, as the readers do, on
/// tools that the machine does not have and points outside of where readings were (to a hundredth of the travel).
Result<FieldAtPoints> field_at_points(const FieldRequest& request);

}  // namespace axiometry::app
