// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/text_lines.h"

#include <algorithm>

#include "axiometry/base/text/text.h"

namespace axiometry::formats {

TextPosition TextLine::at(std::string_view part) const {
  if (part.empty()) return {number, column};
  return {number, column + static_cast<std::size_t>(part.data() - text.data())};
}

std::vector<TextLine> content_lines(std::string_view text) {
  std::vector<TextLine> lines;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t line_break = text.find('\n', begin);
    const std::size_t end = std::min(line_break, text.size());
    const std::string_view content = text::trim(text.substr(begin, end - begin));
    ++number;
    if (!content.empty())
      lines.push_back({.text = content,
                       .number = number,
                       .column = static_cast<std::size_t>(content.data() - text.data()) - begin + 1,
                       .has_break = line_break != std::string_view::npos});
    begin = end + 1;
  }
  return lines;
}

std::string plain_name(std::string_view name) {
  std::string plain;
  std::string spaced = text::to_lower(name);
  std::ranges::replace_if(
      spaced, [](char c) { return c == '-' || c == '_'; }, ' ');
  for (std::string_view word : text::words(spaced)) {
    if (!plain.empty()) plain += ' ';
    plain += word;
  }
  return plain;
}

std::optional<TaggedValue> tagged_value(std::string_view line, char mark) {
  const std::size_t at = line.find(mark);
  if (at == std::string_view::npos) return std::nullopt;
  return TaggedValue{plain_name(line.substr(0, at)), text::trim(line.substr(at + 1))};
}

}  // namespace axiometry::formats
