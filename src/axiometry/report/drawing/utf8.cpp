// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/utf8.h"

#include <algorithm>

namespace axiometry::report {
namespace {

constexpr std::string_view replacement = "\uFFFD";

/// XML 1.0 forbids most controls and U+FFFE, U+FFFF; C1 controls have no picture.
bool cannot_be_shown(char32_t code) {
  const bool moves_on = code == '\t' || code == '\n';
  return (code < 0x20 && !moves_on) || (code >= 0x7f && code < 0xa0) || code == 0xfffe || code == 0xffff;
}

}  // namespace

std::string cleaned(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    if (c.code == '\r') {
      result += ' ';
    } else if (!c.valid() || cannot_be_shown(c.code)) {
      result += replacement;
    } else {
      result += text.substr(at, c.length);
    }
    at += c.length;
  }
  return result;
}

std::string printable(std::string_view text) {
  std::string line = cleaned(text);
  std::ranges::replace_if(
      line, [](char c) { return c == '\t' || c == '\n'; }, ' ');
  return line;
}

}  // namespace axiometry::report
