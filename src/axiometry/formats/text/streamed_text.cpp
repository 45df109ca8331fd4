// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/streamed_text.h"

#include <initializer_list>
#include <utility>

namespace axiometry::formats {
namespace {

constexpr char32_t no_character = 0xFFFD;

char16_t unit_at(std::string_view bytes, std::size_t low, std::size_t high) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(bytes[k])); };
  return static_cast<char16_t>(byte(low) | byte(high) << 8);
}

void put_utf8(std::string& text, char32_t code) {
  const auto put = [&](char32_t first, std::initializer_list<int> shifts) {
    text += static_cast<char>(first);
    for (const int shift : shifts) text += static_cast<char>(0x80 | (code >> shift & 0x3F));
  };
  if (code < 0x80)
    put(code, {});
  else if (code < 0x800)
    put(0xC0 | code >> 6, {0});
  else if (code < 0x10000)
    put(0xE0 | code >> 12, {6, 0});
  else
    put(0xF0 | code >> 18, {12, 6, 0});
}

}  // namespace

std::string_view StreamedText::decoded(std::string_view bytes) {
  if (order_ == Order::no_matter) return bytes;
  begun_ += bytes;
  if (order_ == Order::not_known) {
    if (begun_.empty() || begun_ == "\xFF" || begun_ == "\xFE") return {};  // half of a mark
    order_ = begun_.starts_with("\xFF\xFE")   ? Order::low_first
             : begun_.starts_with("\xFE\xFF") ? Order::high_first
                                              : Order::no_matter;
    if (order_ == Order::no_matter) return text_ = std::exchange(begun_, {});
    begun_.erase(0, 2);
  }
  text_.clear();
  std::size_t at = 0;
  const std::size_t low = order_ == Order::low_first ? 0 : 1;
  for (; at + 2 <= begun_.size(); at += 2) put(unit_at(begun_, at + low, at + 1 - low));
  begun_.erase(0, at);
  return text_;
}

void StreamedText::interrupted() {
  begun_.clear();
  high_ = 0;
}

void StreamedText::put(char16_t unit) {
  const bool high = unit >= 0xD800 && unit < 0xDC00, low = unit >= 0xDC00 && unit < 0xE000;
  const char16_t before = std::exchange(high_, high ? unit : char16_t{0});
  if (before != 0 && low) return put_utf8(text_, 0x10000 + ((before - 0xD800u) << 10) + (unit - 0xDC00u));
  if (before != 0) put_utf8(text_, no_character);
  if (!high) put_utf8(text_, low ? no_character : char32_t{unit});
}

}  // namespace axiometry::formats
