// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/folded_text.h"

#include <algorithm>

namespace axiometry::store {
namespace {

struct Letter {
  char32_t code = 0;
  std::size_t bytes = 1;
};

/// Of valid UTF-8; a byte that begins nothing stands for itself.
Letter letter_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[at + k]); };
  const std::size_t left = text.size() - at;
  if (byte(0) >= 0xC0 && byte(0) < 0xE0 && left >= 2) return {(byte(0) & 0x1Fu) << 6 | (byte(1) & 0x3Fu), 2};
  const std::size_t bytes = byte(0) < 0xC0 ? 1 : byte(0) < 0xF0 ? 3 : 4;
  return {0, std::min(bytes, left)};  // not needed: no capital letter of these scripts is there
}

/// Capitals of two bytes (Unicode's blocks Latin-1, Latin Extended-A, Greek, Cyrillic).
char32_t small(char32_t code) {
  if (code >= 0xC0 && code <= 0xDE && code != 0xD7) return code + 32;
  const bool odd_capitals = (code >= 0x139 && code <= 0x148) || (code >= 0x179 && code <= 0x17E);
  const bool pairs = code >= 0x100 && code <= 0x17E && code != 0x130 && code != 0x131 && code != 0x138 &&
                     code != 0x149 && code != 0x178;
  if (pairs) return odd_capitals ? code + (code & 1) : code | 1;
  if (code == 0x178) return 0xFF;
  if (code >= 0x391 && code <= 0x3A9) return code + 32;
  if (code >= 0x400 && code <= 0x40F) return code + 80;
  if (code >= 0x410 && code <= 0x42F) return code + 32;
  return code;
}

}  // namespace

std::string folded(std::string_view utf8, std::size_t largest) {
  std::string result;
  result.reserve(std::min(utf8.size(), largest));
  for (std::size_t at = 0; at < utf8.size();) {
    const Letter letter = letter_at(utf8, at);
    if (result.size() + letter.bytes > largest) break;
    if (letter.code != 0) {
      const char32_t code = small(letter.code);
      result += static_cast<char>(0xC0 | code >> 6);
      result += static_cast<char>(0x80 | (code & 0x3F));
    } else if (letter.bytes == 1) {
      const char c = utf8[at];
      result += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    } else {
      result += utf8.substr(at, letter.bytes);
    }
    at += letter.bytes;
  }
  return result;
}

}  // namespace axiometry::store
