// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/name_words.h"

#include <algorithm>
#include <string>

#include "axiometry/base/text/text.h"

namespace axiometry::formats {
namespace {

bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital_letter(char c) { return c >= 'A' && c <= 'Z'; }
/// Bytes of UTF-8 beyond ASCII count as letters: "ä", "ß".
bool is_word_letter(char c) {
  return is_small_letter(c) || is_capital_letter(c) || static_cast<unsigned char>(c) >= 0x80;
}

bool parts_words(std::string_view name, std::size_t at) {
  if (at == 0 || at >= name.size()) return true;
  const char before = name[at - 1], after = name[at];
  return !is_word_letter(before) || !is_word_letter(after) || (is_small_letter(before) && is_capital_letter(after));
}

}  // namespace

bool has_word(std::string_view name, const NameWord& sought) {
  const std::string lower = text::to_lower(name);
  for (std::size_t at = lower.find(sought.word); at != lower.npos; at = lower.find(sought.word, at + 1)) {
    const std::size_t end = at + sought.word.size();
    const bool front = parts_words(name, at);
    const bool back = parts_words(name, end) || std::string_view(lower).substr(end).starts_with("temp");
    switch (sought.place) {
      case WordPlace::whole:
        if (front && back) return true;
        break;
      case WordPlace::front:
        if (front) return true;
        break;
      case WordPlace::front_or_back:
        if (front || back) return true;
        break;
      case WordPlace::back:
        if (back) return true;
        break;
      case WordPlace::anywhere: return true;
    }
  }
  return false;
}

bool has_any_word(std::string_view name, std::span<const NameWord> sought) {
  return std::ranges::any_of(sought, [&](const NameWord& word) { return has_word(name, word); });
}

}  // namespace axiometry::formats
