// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/serious_findings.h"

#include <fmt/format.h>

#include <cstdio>

#include "cli/failure.h"

namespace axiometry::cli {

void tell_serious(std::span<const NamedFinding> findings) {
  for (const NamedFinding& finding : findings)
    if (finding.serious) fmt::print(stderr, "axiometry: {}: {}\n", told_fault("serious"), told_fault(finding.message));
}

}  // namespace axiometry::cli
