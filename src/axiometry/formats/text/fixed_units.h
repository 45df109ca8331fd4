// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <span>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/formats/text/text_lines.h"

/// Formats whose units are given by their layout, and files of them that say otherwise.
namespace axiometry::formats {

/// Fails on a line that states another unit than these: "Units: inch", "Unit = um", "// units: um", "[UNIT]" above
/// "VALUE = inch". Files were edited, or written by a program that knows another layout of the same name.
Result<void> expect_fixed_units(std::span<const TextLine> lines, std::initializer_list<std::string_view> own);

}  // namespace axiometry::formats
