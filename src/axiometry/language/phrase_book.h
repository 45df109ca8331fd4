// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "axiometry/language/language.h"
#include "axiometry/language/phrase_file.h"

/// The phrases of one language, prepared for looking up.
namespace axiometry::language {

enum class PlaceKind { text, optional_text, amount, verbatim };

/// A phrase with places: literal, place, literal, place, …, literal.
struct Pattern {
  struct Place {
    std::size_t number = 0;
    PlaceKind kind = PlaceKind::text;
  };
  const Phrase* phrase = nullptr;
  std::vector<std::string> literals;  ///< one more than places; blanks instead of no-break spaces
  std::vector<Place> places;
  std::size_t literal_length = 0;

  std::string_view first() const { return literals.front(); }
  std::string_view last() const { return literals.back(); }
};

/// What a pattern's places hold in a text: position and length.
struct Capture {
  std::size_t at = 0;
  std::size_t length = 0;
};
using Captures = std::array<Capture, 12>;  ///< what stands at each place, by its number

/// What a language does to words that meet.
struct Grammar {
  std::string_view last_item;       ///< what stands before the last item of a list for " and "
  std::string_view clauses = "; ";  ///< what stands between its clauses; packed()
  /// Appends what stands at a place that is not verbatim to the text before it, as "de" + "écart" → "d’écart"; absent:
  /// as it is.
  void (*append)(std::string& text, std::string_view content) = nullptr;
  bool nouns_are_capital = false;  ///< so that a title within a sentence keeps its capital letter
  /// What a translator wrote, as it is set: French has no-break spaces before some marks; absent: as it is.
  std::string (*set)(std::string_view text) = nullptr;
};

class PhraseBook {
 public:
  /// Of pairs but those of the page. Contract: the places of both texts agree.
  PhraseBook(std::vector<PhrasePair> pairs, const Grammar& grammar);
  PhraseBook(const PhraseBook&) = delete;
  PhraseBook& operator=(const PhraseBook&) = delete;

  const Grammar& grammar() const { return grammar_; }

  std::span<const Phrase> phrases() const { return phrases_; }

  /// The other text of a phrase without places; nothing when there is none. Blanks instead of no-break spaces.
  std::optional<std::string_view> literal(const std::string& english) const;

  /// Patterns that may fit a text with this first byte, those with the longest literal part first.
  std::span<const Pattern* const> candidates(char first) const;

 private:
  Grammar grammar_;
  std::vector<PhrasePair> pairs_;  ///< the texts that phrases_ refers to
  std::vector<Phrase> phrases_;
  std::unordered_map<std::string, std::string_view> literals_;
  std::vector<Pattern> patterns_;
  std::array<std::vector<const Pattern*>, 256> by_first_byte_;
};

}  // namespace axiometry::language
