// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/plan/plan.h"
#include "axiometry/report/report.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

/// What `axiometry plan` prints: programme, targets, findings, duration, verdict.
std::string plan_summary(const app::PlannedTest& planned, const report::Options& options, const Terminal& terminal);

}  // namespace axiometry::cli
