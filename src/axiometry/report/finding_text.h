// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/report/report.h"

namespace axiometry::report {

/// The message of a finding with its deviations in the unit that was asked for: values of parameters, and what they
/// would be otherwise, end where the parameter does everywhere else; all others have three significant digits.
std::string shown_message(const iso230_2::Finding& finding, const iso230_2::Assessment& assessment, AxisKind kind,
                          const Options& options);

/// Findings with that message, for who sets them.
iso230_2::Finding shown_finding(const iso230_2::Finding& finding, const iso230_2::Assessment& assessment, AxisKind kind,
                                const Options& options);
std::vector<iso230_2::Finding> shown_findings(std::span<const iso230_2::Finding> findings,
                                              const iso230_2::Assessment& assessment, AxisKind kind,
                                              const Options& options);

}  // namespace axiometry::report
