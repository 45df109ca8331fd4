// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/text/utf8.h"

namespace axiometry::report {

/// Valid UTF-8 without control characters other than line feed and tabulator: a carriage return becomes a
/// blank, what cannot be shown U+FFFD.
std::string cleaned(std::string_view text);

/// cleaned(), on one line: line breaks and tabs become blanks.
std::string printable(std::string_view text);

}  // namespace axiometry::report
