// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

/// Small text tools, all independent of the locale and working on bytes (UTF-8 where it matters).
namespace axiometry::text {

std::string_view trim(std::string_view s);  ///< the text without blanks, tabs, CR and LF at both ends
std::string to_lower(std::string_view s);   ///< ASCII letters only
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// Whether a word is one of these, in any case.
bool is_one_of(std::string_view word, const std::ranges::input_range auto& words) {
  return std::ranges::any_of(words, [&](std::string_view w) { return equal_ignoring_case(w, word); });
}

std::vector<std::string_view> split(std::string_view s, char separator);  ///< "a||b" gives three parts
std::vector<std::string_view> words(std::string_view s);                  ///< separated by blanks and tabs, none empty

/// Byte index of the first byte that is not valid UTF-8, or nothing.
std::optional<std::size_t> invalid_utf8(std::string_view s);

/// Printable form of what was found in a file, for messages: quoted, control and invalid bytes as
/// \xNN, at most 40 characters.
std::string quoted(std::string_view s);

/// A cell of a CSV table (RFC 4180), in quotation marks where it must be.
std::string csv_cell(std::string_view s, char separator = ',');

/// Text of others for a table: behind an apostrophe where a spreadsheet would take it for a formula and run it.
std::string no_formula(std::string_view s);

/// The candidate with the smallest edit distance to `word`, if that is at most a third of its length. Nothing for words
/// of more than read_budget::name_bytes, which are no typing errors.
std::optional<std::string_view> nearest(std::string_view word, const std::vector<std::string_view>& candidates);

/// The name of a file without the folders of this machine, which are nobody's business.
inline std::string_view without_folders(std::string_view path) {
  return path.substr(path.find_last_of("/\\") + 1);  // npos + 1 is 0
}

}  // namespace axiometry::text
