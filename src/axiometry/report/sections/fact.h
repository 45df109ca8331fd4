// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/report/sections/sections.h"

/// Private to this folder.
namespace axiometry::report {

/// A name and a text of the program beside it.
inline Fact fact(std::string_view name, std::string_view value) { return {plain(name), text_cell(value)}; }

}  // namespace axiometry::report
