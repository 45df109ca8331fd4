// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

#include "axiometry/model/tracking.h"

/// What a length reading is called in messages. Private to tracking/.
namespace axiometry::tracking {

/// "target 3↑ run 2"
inline std::string reading_name(const LengthReading& r) {
  return fmt::format("target {}{} run {}", r.approach.target + 1, arrow(r.approach.direction), r.approach.run + 1);
}

/// "target 3↑ run 2 of line xy"
inline std::string reading_name_with_line(const LengthReading& r) {
  return fmt::format("{} of line {}", reading_name(r), r.line);
}

}  // namespace axiometry::tracking
