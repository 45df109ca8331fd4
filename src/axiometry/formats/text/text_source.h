// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"

namespace axiometry::formats {

/// The text of a file, without a UTF-8 byte order mark. Fails, with the place, on an empty file, on
/// UTF-16 and UTF-32, on binary content (a NUL byte, or the signature of an archive, a PDF or a
/// picture), and on text whose lines end in CR alone. Works on a head cut anywhere; does not check UTF-8.
Result<std::string_view> readable_text(std::string_view bytes);

/// Whether bytes begin as an archive does, or as a spreadsheet: what it holds nobody knows before it is unpacked or
/// saved as text.
bool is_packed(std::string_view bytes);

/// readable_text() for a whole file; fails also on the first byte that is not UTF-8.
Result<std::string_view> utf8_text(std::string_view bytes);

/// Fails on a byte that is not UTF-8, naming it. `line` is the number of the first line of `text`.
Result<void> check_utf8(std::string_view text, std::size_t line = 1);

/// The same result with a place, when it is an error that does not have one.
template <typename T>
Result<T> placed(Result<T> result, TextPosition at) {
  if (!result && result.error().at.line == 0) result.error().at = at;
  return result;
}

}  // namespace axiometry::formats
