// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/phrase_book.h"

#include <algorithm>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/language/packed_text.h"

namespace axiometry::language {
namespace {

PlaceKind kind_of(std::string_view mark) {
  if (mark == "?") return PlaceKind::optional_text;
  if (mark == "#") return PlaceKind::amount;
  if (mark == "=") return PlaceKind::verbatim;
  AXIOMETRY_CONTRACT(mark.empty());
  return PlaceKind::text;
}

Pattern parsed(const Phrase& phrase) {
  Pattern pattern{&phrase, {}, {}, 0};
  std::string_view rest = phrase.english;
  for (std::size_t open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
    const std::size_t close = rest.find('}', open);
    AXIOMETRY_CONTRACT(close != std::string_view::npos && close >= open + 2);
    pattern.literals.push_back(with_blanks(packed(rest.substr(0, open))));
    pattern.places.push_back(
        {static_cast<std::size_t>(rest[open + 1] - '0'), kind_of(rest.substr(open + 2, close - open - 2))});
    AXIOMETRY_CONTRACT(pattern.places.back().number < Captures{}.size());
    rest.remove_prefix(close + 1);
  }
  pattern.literals.push_back(with_blanks(packed(rest)));
  for (const std::string& literal : pattern.literals) pattern.literal_length += literal.size();
  return pattern;
}

}  // namespace

PhraseBook::PhraseBook(std::vector<PhrasePair> pairs, const Grammar& grammar)
    : grammar_(grammar), pairs_(std::move(pairs)) {
  std::erase_if(pairs_, &PhrasePair::of_page_alone);
  phrases_.reserve(pairs_.size());  // patterns refer to them
  for (PhrasePair& pair : pairs_) {
    if (grammar_.set) pair.other = grammar_.set(pair.other);
    const Phrase& phrase = phrases_.emplace_back(pair.english, pair.other);
    if (phrase.english.contains('{'))
      patterns_.push_back(parsed(phrase));
    else
      literals_.emplace(with_blanks(packed(phrase.english)), phrase.other);
  }
  std::ranges::stable_sort(patterns_, std::ranges::greater{}, &Pattern::literal_length);
  for (const Pattern& pattern : patterns_)
    if (pattern.first().empty())
      for (auto& of_byte : by_first_byte_) of_byte.push_back(&pattern);
    else
      by_first_byte_[static_cast<unsigned char>(pattern.first().front())].push_back(&pattern);
}

std::optional<std::string_view> PhraseBook::literal(const std::string& english) const {
  const auto found = literals_.find(english);
  return found == literals_.end() ? std::nullopt : std::optional(found->second);
}

std::span<const Pattern* const> PhraseBook::candidates(char first) const {
  return by_first_byte_[static_cast<unsigned char>(first)];
}

}  // namespace axiometry::language
