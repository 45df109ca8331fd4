// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/volumetric/identify/equations/normal_equations.h"

/// What only the shape of the curves seems to tell. Internal to identify().
namespace axiometry::volumetric::detail {

/// What lengths do not tell exchanges errors with each other, as a rotation that is linear in the position with a
/// straightness that is quadratic: curves that cannot bend so, as straight lines between nodes or polynomials of low
/// degree, leave out the one or the other and seem to tell both. So the rank is judged with cubic polynomials too (of
/// an axis that was read at fewer than four places of a degree less than these): directions of raw coefficients, of
/// length 1, each error as near as the curves come to it. Empty where the curves hold all cubics.
std::vector<std::vector<double>> told_by_shape_alone(const Problem& problem, const State& state);

}  // namespace axiometry::volumetric::detail
