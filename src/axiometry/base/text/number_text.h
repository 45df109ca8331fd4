// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Numbers as text, independent of the locale. Reading is exact (nearest double), writing the shortest
/// text that reads back as the same double unless digits are asked for.
namespace axiometry {

/// The number that the whole of `text` spells with a decimal point: "-4.1", ".0016", "+3e-2". Nothing
/// when it is no number, has anything around it, is NaN or infinite, or overflows.
std::optional<double> parse_number(std::string_view text);

/// Whole non-negative number; nothing otherwise or on overflow.
std::optional<unsigned long long> parse_count(std::string_view text);

/// Shortest text that reads back as the same double: "0.1", "1e-09". Always a decimal point.
std::string format_exact(double x);

/// The same with a true minus sign (U+2212), never "−0": in sentences.
std::string format_shortest(double x);

/// How figures are shown to people.
struct NumberStyle {
  char decimal_mark = '.';  ///< '.' or ','
};

/// Fixed number of decimals, a true minus sign (U+2212), never "−0.0". A negative number of decimals rounds to
/// tens, hundreds and so on: 4271 with −2 is "4300".
std::string format_fixed(double x, int decimals, NumberStyle style = {});

/// Decimals at which an uncertainty shows `digits` significant digits (GUM 7.2.6): 0.0234 with two
/// digits gives 3, 14.4 gives 0, 4271 gives −2, 0 gives 0. At most 9, at least −9.
int decimals_for(double uncertainty, int digits);

}  // namespace axiometry
