// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/packed_text.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "axiometry/base/contract.h"

namespace axiometry::language {
namespace {

/// Begins the mark of an argument; two bytes with its number follow, six bits each, which read as no letter either.
constexpr char argument_lead = '\xFF';
constexpr unsigned continuation = 0x80;
constexpr std::size_t mark_length = 3;
constexpr std::size_t most_arguments = 0x1000;
constexpr std::string_view marks_of_packing = "\x1f\xFF";  // no_break, argument_lead

std::size_t bits_of(char byte) { return static_cast<unsigned char>(byte) & 0x3FU; }

void append_words(TextPieces& pieces, std::string_view words) {
  if (words.empty()) return;
  if (pieces.empty() || !std::holds_alternative<std::string>(pieces.back())) pieces.emplace_back(std::string());
  std::get<std::string>(pieces.back()) += words;
}

}  // namespace

std::string packed(std::string_view text) {
  std::string all;
  all.reserve(text.size());
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool is_space = text.substr(k).starts_with(no_break_space);
    all += is_space ? no_break : text[k];
    if (is_space) ++k;
  }
  return all;
}

std::string with_blanks(std::string_view packed) {
  std::string all(packed);
  std::ranges::replace(all, no_break, ' ');
  return all;
}

PackedText::PackedText(const TextPieces& pieces) {
  for (const TextPiece& piece : pieces)
    if (const auto* words = std::get_if<std::string>(&piece))
      add_words(*words);
    else
      add_argument(piece);
}

void PackedText::add_words(std::string_view words) {
  while (!words.empty()) {
    const std::size_t begin = std::min(words.find_first_of(marks_of_packing), words.size());
    text_ += packed(words.substr(0, begin));
    words.remove_prefix(begin);
    const std::size_t end = std::min(words.find_first_not_of(marks_of_packing), words.size());
    if (end > 0) add_argument(std::string(words.substr(0, end)));
    words.remove_prefix(end);
  }
}

void PackedText::add_argument(TextPiece argument) {
  const auto number = static_cast<unsigned>(arguments_.size());
  AXIOMETRY_CONTRACT(number < most_arguments);
  text_ +=
      {argument_lead, static_cast<char>(continuation | number >> 6), static_cast<char>(continuation | (number & 0x3F))};
  arguments_.push_back(std::move(argument));
}

TextPieces PackedText::unpacked(std::string_view packed) const {
  TextPieces pieces;
  while (!packed.empty()) {
    const std::size_t begin = std::min(packed.find_first_of(marks_of_packing), packed.size());
    append_words(pieces, packed.substr(0, begin));
    packed.remove_prefix(begin);
    if (packed.starts_with(no_break)) {
      append_words(pieces, no_break_space);
      packed.remove_prefix(1);
    } else if (!packed.empty()) {
      AXIOMETRY_CONTRACT(packed.size() >= mark_length);
      const TextPiece& argument = arguments_.at(bits_of(packed[1]) << 6 | bits_of(packed[2]));
      if (const auto* words = std::get_if<std::string>(&argument))
        append_words(pieces, *words);
      else
        pieces.push_back(argument);
      packed.remove_prefix(mark_length);
    }
  }
  return pieces;
}

bool cuts_argument(std::string_view packed, std::size_t at) {
  if (at >= packed.size()) return false;
  return (at >= 1 && packed[at - 1] == argument_lead) || (at >= 2 && packed[at - 2] == argument_lead);
}

}  // namespace axiometry::language
