// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/safe_text.h"

#include <algorithm>
#include <array>

#include "axiometry/base/text/utf8.h"

namespace axiometry::nc {
namespace {

/// U+00C0 to U+00FF; capitals, since programs have no others.
constexpr std::array<std::string_view, 64> latin = {
    "A", "A", "A", "A", "AE", "A", "AE", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",   //
    "D", "N", "O", "O", "O",  "O", "OE", "X", "O", "U", "U", "U", "UE", "Y", "TH", "SS",  //
    "A", "A", "A", "A", "AE", "A", "AE", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",   //
    "D", "N", "O", "O", "O",  "O", "OE", "/", "O", "U", "U", "U", "UE", "Y", "TH", "Y"};

/// In ASCII, before it is looked at whether that is allowed.
std::string plain(char32_t c) {
  if (c >= 'a' && c <= 'z') return {static_cast<char>(c - 'a' + 'A')};
  if (c == '\n' || c == '\r' || c == '\t') return " ";
  if (c < 0x80) return {static_cast<char>(c)};
  if (c == 0xB0) return " DEG";
  if (c == 0xB5 || c == 0x3BC) return "U";
  if (c >= 0xC0 && c <= 0xFF) return std::string(latin[c - 0xC0]);
  return "-";
}

}  // namespace

std::string safe_text(std::string_view utf8, std::string_view allowed) {
  std::string safe;
  while (!utf8.empty()) {
    const Character c = character_at(utf8, 0);
    utf8.remove_prefix(c.length);
    for (char ascii : plain(c.code)) {
      if (allowed.find(ascii) == std::string_view::npos) ascii = ascii == '(' ? '[' : ascii == ')' ? ']' : ascii;
      const bool harmless = (ascii >= 'A' && ascii <= 'Z') || (ascii >= '0' && ascii <= '9') || ascii == ' ' ||
                            allowed.find(ascii) != std::string_view::npos;
      safe += harmless ? ascii : '-';
    }
  }
  return safe;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> parts;
  while (text.size() > width) {
    const std::size_t blank = text.rfind(' ', width);
    const bool at_blank = blank != std::string_view::npos && blank > 0;
    const std::size_t end = at_blank ? blank : width;
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(at_blank ? end + 1 : end);
  }
  parts.emplace_back(text);
  return parts;
}

}  // namespace axiometry::nc
