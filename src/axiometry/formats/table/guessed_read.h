// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/formats/table/generic_delimited.h"

namespace axiometry::formats {

/// read_guessed() where the guess about these bytes is made already.
Result<Test> read_guessed(const Guess& found, std::string_view bytes);

}  // namespace axiometry::formats
