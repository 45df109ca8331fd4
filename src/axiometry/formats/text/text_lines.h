// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"

/// Lines of small text files, with the place of everything in them.
namespace axiometry::formats {

struct TextLine {
  std::string_view text;   ///< line without blanks at its ends, never empty
  std::size_t number = 0;  ///< number of the line, from 1
  std::size_t column = 1;  ///< column of the first byte of `text`
  bool has_break = true;   ///< false for the last line of a file that ends within it

  /// Where a part of `text` stands; the beginning of the line for a part that is empty.
  TextPosition at(std::string_view part) const;
};

/// Every line that is not blank.
std::vector<TextLine> content_lines(std::string_view text);

/// "Air temp : 20.1 C": what stands on both sides of the first mark.
struct TaggedValue {
  std::string tag;  ///< lower case, parts separated by one blank, also where the file has hyphens and underscores
  std::string_view value;  ///< value without blanks at its ends; may be empty
};

/// Nothing when the line has no mark.
std::optional<TaggedValue> tagged_value(std::string_view line, char mark = ':');

/// A tag or the name of a column as tagged_value() spells it.
std::string plain_name(std::string_view name);

}  // namespace axiometry::formats
