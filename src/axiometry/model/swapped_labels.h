// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "axiometry/model/test.h"

/// A file whose labels of direction contradict the order of its rows: one of both is wrong, and with the labels ↑ and ↓
/// of all results and the sign of B would be.
namespace axiometry {

inline constexpr std::string_view swapped_labels =
    "the targets run the other way than the labels of direction say: rows called ↑ go down and rows called ↓ go up; "
    "the labels were taken as they stand";

inline SourceRemark swapped_labels_remark() { return {false, std::string(swapped_labels), true}; }

inline bool has_swapped_labels(const Test& test) {
  return std::ranges::any_of(test.provenance.remarks, &SourceRemark::of_swapped_labels);
}

}  // namespace axiometry
