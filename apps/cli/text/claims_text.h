// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/iso230_2/rules/claims.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

/// A line for each claim; of the test's, what was not stated, since no finding tells it. Ends with an empty line.
std::string claims_text(const app::Evaluated& e, const iso230_2::Claims& claims, const report::Options& options,
                        const Terminal& terminal);

}  // namespace axiometry::cli
