// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/standards/iso230_2/periodic/periodic.h"

namespace axiometry::iso230_2 {

/// How a test for a periodic error departs from Annex C, and what its result must not be taken for; departures first.
/// For periodic.cpp alone.
std::vector<Finding> periodic_findings(const Test& test, std::span<const PeriodicDirection> directions);

}  // namespace axiometry::iso230_2
