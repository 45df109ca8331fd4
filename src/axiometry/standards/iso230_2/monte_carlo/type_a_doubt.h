// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"

namespace axiometry::iso230_2 {

/// Why an interval from these trials is worth less than its probability; empty where nothing is known against it.
/// Measured in docs/studies/coverage.md: each of both other ways held the true value in fewer tests than it states, at
/// some size of the scatter. Cells taken for themselves and runs drawn again do not see that extremes grow with noise.
std::string doubt_of_type_a(Measurand measurand, TypeA type_a);

}  // namespace axiometry::iso230_2
