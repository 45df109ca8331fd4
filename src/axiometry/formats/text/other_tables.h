// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/result.h"

namespace axiometry::formats {

/// Fails, saying what it is and what takes it, on a table of this program that holds no readings of a test: a report, a
/// table of results, tolerance tables, lengths. `text` is the beginning of the file.
Result<void> check_no_other_table(std::string_view text);

}  // namespace axiometry::formats
