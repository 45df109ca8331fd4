// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::iso230_2 {

/// The straight part of the deviations. The standard knows no such parameter and nothing is removed: it
/// tells where E and A come from.
struct Slope {
  double per_position_native = 0.0;  ///< µm/mm on a linear axis, ″/° on a rotary one
  Deviation remainder;               ///< E (3.24) of the means about the line
};

/// Least squares through the unidirectional means of both directions. Absent where targets lie so near or so
/// far from each other that the squares of their distances are no numbers.
std::optional<Slope> slope_of_means(std::span<const PositionResult> positions);

}  // namespace axiometry::iso230_2
