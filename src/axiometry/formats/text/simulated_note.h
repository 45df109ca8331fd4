// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The line above a table of lengths by which a simulation says that nobody measured them.
namespace axiometry::formats {

/// What is told of such a table.
inline constexpr std::string_view simulated_lengths = "the lengths are simulated, not measured, as their file says";

/// Whether a comment, with its #, is that line.
bool is_simulated_note(std::string_view comment);

}  // namespace axiometry::formats
