// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/safe_text.h"

#include <algorithm>
#include <array>

namespace axiometry::nc {
namespace {

/// U+00C0 to U+00FF; capitals, since programs have no others.
constexpr std::array<std::string_view, 64> latin = {
    "A", "A", "A", "A", "AE", "A", "AE", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",   //
    "D", "N", "O", "O", "O",  "O", "OE", "X", "O", "U", "U", "U", "UE", "Y", "TH", "SS",  //
    "A", "A", "A", "A", "AE", "A", "AE", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",   //
    "D", "N", "O", "O", "O",  "O", "OE", "/", "O", "U", "U", "U", "UE", "Y", "TH", "Y"};

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;
};

/// The character at the beginning of `s`; 0xFFFD where it is no valid UTF-8. Characters above U+07FF need not be told
/// apart: none has a replacement but the minus sign.
CodePoint first_code_point(std::string_view s) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(s[k]); };
  const unsigned char lead = byte(0);
  const std::size_t size = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 0;
  if (size == 1) return {lead, 1};
  if (size == 0 || size > s.size()) return {0xFFFD, 1};
  char32_t value = size == 2 ? lead & 0x1Fu : size == 3 ? lead & 0x0Fu : lead & 0x07u;
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(k) & 0xC0u) != 0x80u) return {0xFFFD, 1};
    value = value << 6 | (byte(k) & 0x3Fu);
  }
  return {value, size};
}

/// In ASCII, before it is looked at whether that is allowed.
std::string plain(char32_t c) {
  if (c >= 'a' && c <= 'z') return {static_cast<char>(c - 'a' + 'A')};
  if (c == '(') return "[";
  if (c == ')') return "]";
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
    const CodePoint c = first_code_point(utf8);
    utf8.remove_prefix(c.bytes);
    for (char ascii : plain(c.value)) {
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
