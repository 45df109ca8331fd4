// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/tracking/tracking_evaluate.h"
#include "axiometry/report/report.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

/// What `axiometry tracking evaluate` prints: a row for each line, the largest of the diagonals, scales and squareness,
/// findings, verdicts.
std::string lines_summary(const app::EvaluatedLines& evaluated, const report::Options& options,
                          const Terminal& terminal);

}  // namespace axiometry::cli
