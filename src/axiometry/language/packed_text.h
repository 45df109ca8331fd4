// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/language/language.h"

namespace axiometry::language {

inline constexpr std::string_view no_break_space = "\u00a0";

/// No-break spaces as one byte (no_break), so that a text and its form with blanks have the same length.
inline constexpr char no_break = '\x1f';
std::string packed(std::string_view text);
std::string with_blanks(std::string_view packed);

/// A text as phrases are looked up in it: packed, and for each argument a mark of three bytes that no UTF-8 holds.
/// Bytes of the given text that would read as one of the two are arguments themselves: whatever it holds comes back.
class PackedText {
 public:
  explicit PackedText(const TextPieces& pieces);  ///< contract: at most 4096 arguments

  const std::string& text() const { return text_; }

  /// The pieces of a text that holds marks of this one only, each of them whole.
  TextPieces unpacked(std::string_view packed) const;

 private:
  void add_words(std::string_view words);
  void add_argument(TextPiece argument);

  std::string text_;
  std::vector<TextPiece> arguments_;
};

/// Whether a text that is cut at a byte loses part of an argument.
bool cuts_argument(std::string_view packed, std::size_t at);

}  // namespace axiometry::language
