// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/results/experiment.h"

namespace axiometry::app {

/// tracking::tracker_kinds() as a table and as JSON.
Experiment tracker_list(const report::Options& options);

}  // namespace axiometry::app
