// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "axiometry/language/phrase_book.h"

/// Reads one text with a phrase book, packed: an argument in it is a sign, no word.
namespace axiometry::language {

class PhraseReader {
 public:
  PhraseReader(const PhraseBook& book, const NumberStyle& numbers) : book_(book), numbers_(numbers) {}

  struct Answer {
    TextPieces text;
    bool known = false;  ///< all of it
  };
  Answer read(const TextPieces& text);

 private:
  using Found = std::optional<std::string>;

  Found whole(std::string_view packed, int depth);    ///< an entry, all of whose places are known
  Found variant(std::string_view packed, int depth);  ///< the same as a sentence or as a title within one
  Found by_sentence(std::string_view packed, int depth);
  Found by_item(std::string_view packed, int depth);  ///< looks up a list
  Found known(std::string_view packed, int depth);    ///< any of these
  Found set(const Pattern& pattern, const std::string& blanks, std::string_view packed, int depth, bool strict);
  bool fits(const Pattern& pattern, const std::string& blanks, std::size_t piece, std::size_t at, Captures& captures);
  bool works(std::size_t bytes);  ///< takes so much from the work that is left; false when nothing is
  std::string sentence_or_part(std::string_view packed);
  std::string roughly(std::string_view packed);

  const PhraseBook& book_;
  NumberStyle numbers_;
  long work_left_ = 3'000'000;  ///< work for one text, in bytes looked at
};

}  // namespace axiometry::language
