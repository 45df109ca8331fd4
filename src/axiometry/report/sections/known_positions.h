// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/compensation.h"

namespace axiometry::report {

/// To within what the positions of an axis are known once a table corrects it: the largest in a sentence, each target
/// in a table.
Section known_positions_section(const KnownPositions& known, AxisKind kind, const Options& options);

}  // namespace axiometry::report
