// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"

/// What a person gives for the archive: names, titles, notes, numbers of records.
namespace axiometry::app {

inline constexpr std::size_t line_length_max = 500;    ///< characters of a name or title
inline constexpr std::size_t text_length_max = 10000;  ///< characters of notes and of a metadata item

/// Seeds that are given as numbers are below: whole numbers of JSON.
inline constexpr std::uint64_t seed_limit = std::uint64_t{1} << 53;

/// The text without blanks around it. Fails, naming `what`, on bytes that are not UTF-8, on control characters, on
/// marks that turn the direction of writing (behind which another name can hide) and beyond line_length_max.
Result<std::string> given_line(std::string_view what, std::string_view text);

/// The same for text of several lines, up to text_length_max; line breaks and tabs may stand in it.
Result<std::string> given_text(std::string_view what, std::string_view text);

/// The last part of the name of a file that somebody sends, which is a name and nothing else: no path. Fails as
/// given_line() does; "unnamed" when nothing is left.
Result<std::string> given_file_name(std::string_view name);

/// A whole number from 1 to store::id_max: an id or a version. Fails, with line and column, on anything else.
Result<std::int64_t> given_number(std::string_view what, const json::Value& value);

/// The same as versions are counted.
Result<int> given_version(std::string_view what, const json::Value& value);

}  // namespace axiometry::app
