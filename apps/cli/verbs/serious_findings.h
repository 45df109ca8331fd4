// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include "axiometry/model/named_finding.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {

/// One rule for all verbs that have findings: exit code 3 where one is serious, which is that the result should not be
/// used as it is. Outputs are written all the same.
int exit_code_of_findings(const auto& findings) {
  return std::ranges::any_of(findings, [](const auto& f) { return f.serious; }) ? exit_exceeded : exit_done;
}

/// Serious ones on the standard error, of what shows none itself.
void tell_serious(std::span<const NamedFinding> findings);

}  // namespace axiometry::cli
