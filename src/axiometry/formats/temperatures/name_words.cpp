// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/name_words.h"

#include <string>

#include "axiometry/base/text.h"

namespace axiometry::formats {
namespace {

struct RoleWord {
  NameWord sought;
  std::string_view role;
};
/// In this order: "air above the bed" is of the air.
constexpr RoleWord words_of_roles[] = {
    {{"air", WordPlace::front}, "air"},
    {{"luft", WordPlace::front_or_back}, "air"},
    {{"ambient", WordPlace::front}, "air"},
    {{"room", WordPlace::front_or_back}, "air"},
    {{"raum", WordPlace::front_or_back}, "air"},
    {{"hall", WordPlace::front}, "air"},
    {{"umgebung", WordPlace::front}, "air"},
    {{"laser", WordPlace::front_or_back}, "equipment"},
    {{"optic", WordPlace::front}, "equipment"},
    {{"interferom", WordPlace::front}, "equipment"},
    {{"material", WordPlace::front}, "machine"},
    {{"machine", WordPlace::front}, "machine"},
    {{"maschine", WordPlace::front_or_back}, "machine"},
    {{"bed", WordPlace::front}, "machine"},
    {{"bett", WordPlace::front_or_back}, "machine"},
    {{"table", WordPlace::front}, "machine"},
    {{"tisch", WordPlace::front_or_back}, "machine"},
    {{"column", WordPlace::front}, "machine"},
    {{"ständer", WordPlace::front_or_back}, "machine"},
    {{"spindle", WordPlace::front_or_back}, "machine"},
    {{"spindel", WordPlace::front_or_back}, "machine"},
    {{"scale", WordPlace::front}, "machine"},
    {{"maßstab", WordPlace::front_or_back}, "machine"},
    {{"screw", WordPlace::front_or_back}, "machine"},
};

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
/// Bytes of UTF-8 beyond ASCII count as letters: "ä", "ß".
bool is_letter(char c) { return is_small(c) || is_capital(c) || static_cast<unsigned char>(c) >= 0x80; }

bool parts_words(std::string_view name, std::size_t at) {
  if (at == 0 || at >= name.size()) return true;
  const char before = name[at - 1], after = name[at];
  return !is_letter(before) || !is_letter(after) || (is_small(before) && is_capital(after));
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

std::optional<std::string_view> sensor_role(std::string_view name) {
  if (name.starts_with("column ")) return std::nullopt;
  for (const RoleWord& row : words_of_roles)
    if (has_word(name, row.sought)) return row.role;
  return std::nullopt;
}

}  // namespace axiometry::formats
