// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/standards/environment/environment.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

namespace axiometry::iso230_2 {

/// The surroundings of a test (4.1) against what the parties agreed on them (7). The standard recommends no limits of
/// its own. Every finding has its key:
/// - environment-lowest-exceeded, -highest-, -rate-, -rate-before-, -gradient-: a departure;
/// - environment-lowest-not-measured, …: a limit was agreed and nobody measured; missing;
/// - environment-known-in-part: limits kept as far as was recorded; missing;
/// - environment-perhaps-exceeded: a limit that was exceeded when nobody knows that the test was; missing;
/// - environment-rate-not-agreed, environment-rate-before-not-agreed: 4.1 wants a limit of them; a note;
/// - environment-gap: what of the time was not recorded, or cannot be placed; a note.
std::vector<Finding> environment_findings(const TestEnvironment& environment, Depth depth = Depth::every_finding);

}  // namespace axiometry::iso230_2
