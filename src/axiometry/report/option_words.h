// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/report/report.h"

/// The words by which a person chooses how a report shows numbers, at the command line, in requests and in Python.
namespace axiometry::report {

/// '.' for "point", ',' for "comma".
Result<char> decimal_mark_of(std::string_view word);

/// "um", "mm", "nm", "deg", "arcsec".
Result<DisplayUnit> unit_of(std::string_view word);

inline constexpr int most_deviation_decimals = 6;

}  // namespace axiometry::report
