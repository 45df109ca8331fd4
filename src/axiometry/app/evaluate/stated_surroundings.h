// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/metadata.h"
#include "axiometry/standards/environment/environment.h"
#include "axiometry/standards/iso230_2/finding.h"

/// What a test states of its surroundings over its time (4.1), and what was agreed on them (7).
namespace axiometry::app {

/// Whether anything of either is stated.
bool states_surroundings(const Metadata& metadata);

/// Fails on a lowest temperature above the highest, measured or agreed.
Result<void> check_surroundings(const Metadata& metadata);

/// Figures that the test states and that its own temperatures of the air, at the start or the end, lie beyond.
std::vector<iso230_2::Finding> contradicted_by_test(const Metadata& metadata);

/// Figures that the test states and that the log tells otherwise, each by more than two thermometers differ. Where the
/// log does not know all of the time, only what it saw beyond a figure contradicts it.
std::vector<iso230_2::Finding> contradicted_by_log(const StatedEnvironment& stated,
                                                   const iso230_2::TestEnvironment& logged);

}  // namespace axiometry::app
