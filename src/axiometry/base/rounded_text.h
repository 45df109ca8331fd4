// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace axiometry {

/// A number of a message, without the digits that arithmetic leaves behind: rounded to `decimals`, zeros at its end
/// left out, never "-0": "12429.236", "0.1". Numbers that a file holds are written by format_exact().
std::string format_rounded(double x, int decimals = 6);

}  // namespace axiometry
