// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/serious_findings.h"

#include <fmt/format.h>

#include <cstdio>

#include "axiometry/report/drawing/utf8.h"

namespace axiometry::cli {

void tell_serious(std::span<const NamedFinding> findings) {
  for (const NamedFinding& finding : findings)
    if (finding.serious) fmt::print(stderr, "axiometry: serious: {}\n", report::printable(finding.message));
}

}  // namespace axiometry::cli
