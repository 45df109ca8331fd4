// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/flags/verb.h"

namespace axiometry::cli {

/// `axiometry temperatures`: what a log of temperatures tells of the surroundings of a test (4.1, 7).
void add_temperatures(const Verb& program, int& exit_code);

}  // namespace axiometry::cli
