// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace axiometry::app {

/// examples/iso230-2-table2.json to the byte: a program that is installed has no folder of examples beside it.
extern const std::string_view example_table2;

}  // namespace axiometry::app
