// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/standards/readings/reading_correction.h"
#include "cli/flags/verb.h"

/// What is done to the readings of a test before they are used.
namespace axiometry::cli {

/// --correct and --nde-correct.
void add_correction_flags(const Verb& verb, CorrectionRequest& request);

}  // namespace axiometry::cli
