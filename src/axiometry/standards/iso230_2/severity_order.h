// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "axiometry/standards/iso230_2/finding.h"

namespace axiometry::iso230_2 {

/// By severity, and those of one as they were. What is in order already, as most lists are, costs no memory.
inline void sort_by_severity(std::vector<Finding>& findings) {
  if (!std::ranges::is_sorted(findings, {}, &Finding::severity))
    std::ranges::stable_sort(findings, {}, &Finding::severity);
}

}  // namespace axiometry::iso230_2
