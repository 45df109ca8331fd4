// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/result.h"

namespace axiometry::app {

/// Puts instructive tests into an empty archive, as if somebody had sent them: the worked example of the standard, a
/// machine whose play grows over two years until it is mended, an axis before and after its compensation, a ball screw
/// that warms up, a rotary table, and an axis in good order. What is simulated says so. The same on every machine.
/// Gives the number of tests; 0, and nothing is added, where the archive has any machine, instrument, plan or test.
Result<std::size_t> add_examples(Workbench& workbench);

}  // namespace axiometry::app
