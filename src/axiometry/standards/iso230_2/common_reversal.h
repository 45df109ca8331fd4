// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::iso230_2 {

/// The part of the reversal errors that is the same at every target. The standard knows no such parameter beside B̄
/// (3.17) and nothing is removed: it tells where B, R, E and A come from.
struct CommonReversal {
  Deviation remainder;     ///< max |B_i − B̄|: B (3.16) without it
  AxisParameters without;  ///< the parameters that the axis would have if every approach from above were B̄ higher
};

/// CommonReversal::remainder alone, at a fraction of the cost: `common` is B̄.
Deviation reversal_remainder(std::span<const PositionResult> positions, Deviation common);

/// Absent where no target has both directions.
std::optional<CommonReversal> common_reversal(std::span<const PositionResult> positions);

}  // namespace axiometry::iso230_2
