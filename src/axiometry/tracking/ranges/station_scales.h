// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/tracking/ranges/multilateration.h"
#include "axiometry/tracking/ranges/range_input.h"

/// Whether the lengths of one station are too long in proportion against those of the others. Internal to
/// multilaterate().
namespace axiometry::tracking::detail {

/// Of a result with one scale. Looked for where χ² is larger than chance mostly makes it: the lengths are solved again
/// with a scale κ_j for each station, which takes m − 1 more unknowns. Told where that lowers χ² by more than 60 times
/// its mean share, as a break of the beam is, and by more than chance does once in a million. Nothing where free scales
/// cannot be told, and never of a scale that all stations have in common: it changes the size and no residual.
std::optional<Finding> scale_finding(const RangeInput& input, const MultilaterationFit& fit);

}  // namespace axiometry::tracking::detail
