// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/result.h"

namespace axiometry::formats {

/// Of a file that no format recognises (format.h): why it may hold a test all the same and must not be passed over in
/// silence, an open question about a table, rows in it that are none, or bytes that are packed. Passes on all else.
Result<void> check_passed_over(std::string_view head);

}  // namespace axiometry::formats
