// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace axiometry {

/// A number of a message, without the digits that arithmetic leaves behind: rounded to `decimals`, zeros at its end
/// left out, never "-0": "12429.236", "0.1". Numbers that a file holds are written by format_exact().
std::string format_rounded(double x, int decimals = 6);

/// So many significant digits, all of what stands before the decimal point, with a true minus sign: "−0.123", "1235".
std::string format_significant(double x, int digits);

/// A probability in a message: "p = 0.0030", and below 0.0001 "p < 0.0001": how far below rests on tails that nobody
/// knows.
std::string format_chance(double p);

}  // namespace axiometry
