// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/tracking/tracking_plan.h"
#include "axiometry/report/report.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

/// What people read after a plan of lines was made: lines, lost lines, remarks, duration.
std::string tracking_plan_summary(const app::PlannedLines& planned, const report::Options& options,
                                  const Terminal& terminal);

}  // namespace axiometry::cli
