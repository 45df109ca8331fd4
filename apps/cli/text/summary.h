// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/report/report.h"
#include "cli/text/method_text.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

/// What `axiometry evaluate FILE` prints: identification, parameters with U, tolerances, the
/// uncertainty by the methods that were run, findings, verdict.
std::string summary(const app::Evaluated& evaluated, const report::Options& options, const Terminal& terminal,
                    Detail detail);

/// The same for many tests, one line each.
std::string line_header(const report::Options& options, const Terminal& terminal);
std::string line(const app::Evaluated& evaluated, const report::Options& options, const Terminal& terminal);

}  // namespace axiometry::cli
