// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/finding.h"

namespace axiometry::iso230_2 {

/// What the times of the readings say against the cycle and the rest at each target that the test states, both
/// departures: another order than that of the cycle, by name where it is that of another one, else with the first two
/// readings that contradict; readings less than half of the stated rest apart. Nothing where no times are known, of a
/// cycle of the user's own, and of readings that have one time.
std::vector<Finding> order_findings(const Test& test);

}  // namespace axiometry::iso230_2
