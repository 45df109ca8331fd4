// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "axiometry/report/report.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

/// One paragraph for each finding, and an empty line below; nothing when there is none.
std::string findings_text(std::span<const iso230_2::Finding> findings, const report::Options& options,
                          const Terminal& terminal);

}  // namespace axiometry::cli
