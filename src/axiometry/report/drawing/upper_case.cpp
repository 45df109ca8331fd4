// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/upper_case.h"

#include "axiometry/base/text/utf8.h"

namespace axiometry::report {
namespace {

/// The capital of a letter of Latin-1 is 0x20 before it, but for ÷ and for ÿ and ß, whose capitals are elsewhere.
bool is_raised_by_32(char32_t code) { return code >= 0xE0 && code <= 0xFE && code != 0xF7; }

}  // namespace

std::string upper_case(std::string_view text) {
  std::string raised;
  raised.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    const std::string_view bytes = text.substr(at, c.length);
    at += c.length;
    if (c.code >= 'a' && c.code <= 'z')
      raised += static_cast<char>(bytes[0] - 'a' + 'A');
    else if (is_raised_by_32(c.code))
      raised.append({bytes[0], static_cast<char>(bytes[1] - 0x20)});
    else if (c.code == U'ß')
      raised += "SS";
    else if (c.code == U'œ')
      raised += "Œ";
    else if (c.code == U'ÿ')
      raised += "Ÿ";
    else
      raised += bytes;
  }
  return raised;
}

}  // namespace axiometry::report
