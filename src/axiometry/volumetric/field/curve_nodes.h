// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "axiometry/volumetric/field/error_model.h"

/// Curves as they are printed and drawn: values at equidistant positions.
namespace axiometry::volumetric {

struct CurveNode {
  double position_mm = 0.0;
  Estimate mean;                               ///< mean of both directions
  std::optional<Estimate> up = {}, down = {};  ///< curves of either direction, where there are both
};

/// From the first to the last reading of the axis, 41 positions by default; none of an error of which the lengths do
/// not tell all.
std::vector<CurveNode> curve_nodes(const ErrorModel& model, ErrorMotion error, std::size_t count = 41);

}  // namespace axiometry::volumetric
