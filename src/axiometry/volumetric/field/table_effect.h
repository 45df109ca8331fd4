// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "axiometry/volumetric/field/volume_statistics.h"

/// What tables of a control leave of the error of the tool point.
namespace axiometry::volumetric {

/// Over the travel that was observed, without rigid motion, µm; means of both directions.
struct TableEffect {
  FieldSizes before, after;  ///< `after` has no uncertainties
};

/// Of what is taken away at each place. Absent where the lengths do not tell the field with this tool. It is looked at
/// between the positions of tables that have `nodes` along each axis, the largest all over (FieldSizes).
/// Contract: 2 ≤ nodes.
std::optional<TableEffect> table_effect(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes,
                                        const std::function<Vector3(Vector3 axes_mm)>& compensated_um);

/// Of tables of all 21 errors at `nodes` positions of each axis, between which a control draws straight lines. Absent
/// as above, and where an error is not told. Contract: 2 ≤ nodes.
std::optional<TableEffect> effect_of_all_errors(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes);

/// What means of both directions leave: the largest displacement, µm, of the tool point from its mean over the ways in
/// which the axes may come to rest. 0 without reversal; absent where errors are not all told by direction.
std::optional<double> half_reversal_um(const ErrorModel& model, Vector3 tool_mm);

}  // namespace axiometry::volumetric
