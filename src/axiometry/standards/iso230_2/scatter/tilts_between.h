// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "axiometry/standards/iso230_2/scatter/direction_tables.h"
#include "axiometry/standards/iso230_2/scatter/outliers.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"

namespace axiometry::iso230_2::scatter {

/// Analysis of variance: the slopes of the runs against what is left beside level, shift and slope. Found where chance
/// exceeds it tilt_level and where they make a fifth of that or more.
std::optional<RunTilts> tilts_between(const Fits& fits, std::span<const double> levers, const Rounding& rounding);

}  // namespace axiometry::iso230_2::scatter
