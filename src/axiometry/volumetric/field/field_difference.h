// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "axiometry/volumetric/field/volume_statistics.h"

/// Two results of one machine, before and after something was done to it.
namespace axiometry::volumetric {

/// δ at the nodes of a grid over the travel that was observed, µm, X fastest; absent where the lengths do not tell it.
/// Contract: 2 ≤ nodes.
std::vector<std::optional<Vector3>> grid_errors(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes);

/// The travel that was observed for both; absent where that is no volume.
std::optional<TravelBox> common_travel(const ErrorModel& a, const ErrorModel& b);

/// The same errors, looked at over a part of the travel that was observed. Contract: within it.
ErrorModel seen_over(const ErrorModel& model, TravelBox box);

/// δ after − δ before over the travel that both were observed in. u is that of two independent calibrations.
struct FieldDifference {
  std::optional<FieldSizes> as_found;              ///< absent where one of them does not tell all
  std::optional<FieldSizes> without_rigid_motion;  ///< likewise; without uncertainty
};
/// Contract: both observed over one and the same travel (seen_over()); 2 ≤ nodes ≤ 101.
FieldDifference field_difference(const ErrorModel& before, const ErrorModel& after, Vector3 tool_mm, std::size_t nodes);

}  // namespace axiometry::volumetric
