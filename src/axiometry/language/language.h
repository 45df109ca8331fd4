// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/base/text/number_text.h"

/// Finished English texts in another language. The rest of the library composes its sentences in English; where a
/// person reads another language they are looked up as a whole, in a phrase book whose entries have places for what
/// differs: "found {0#} runs" → "{0} Läufe gefunden". What a user wrote is never looked up: who sets a text knows which
/// of its parts are such words.
namespace axiometry::language {

enum class Language { english, german, french };

/// Every language there is, English first. What enumerates them (flags, the API, tests) asks here.
std::span<const Language> languages();

/// "en", "de", "fr"; also with a region, "de-AT". Nothing for others.
std::optional<Language> language_of(std::string_view tag);

Result<Language> chosen_language(std::string_view tag);  ///< the same, where another tag is refused

std::string_view tag(Language language);       ///< "en"
std::string_view own_name(Language language);  ///< as its readers call it: "Deutsch"
std::string tags_of_languages();               ///< tags of all languages: "en, de, fr"

/// The decimal mark that readers of a language expect.
NumberStyle usual_numbers(Language language);

/// The best of what an Accept-Language header asks for (RFC 9110, 12.5.4); English when it knows none.
Language best_of(std::string_view accept_language);

/// One entry. Places of the English text are numbered, each appears in the other one as {0}, {1}, …:
///   {0}   a text that is looked up in turn
///   {0?}  the same, or nothing
///   {0#}  an amount: numbers, symbols and units, no words
///   {0=}  what stays as it is, numbers too: names, clauses, words of files
struct Phrase {
  std::string_view english;
  std::string_view other;
};

/// The text in that language: the entry with the longest literal part that fits it as a whole; what stands at its
/// places is looked up in turn, and numbers among it get the decimal mark. An entry fits a sentence too, with its
/// capital letter and full stop. A text of several sentences is looked up as a whole first, then by sentence; a list
/// by its items. Quoted words ('X', "X") stay. What no entry fits stays English, as do texts without a word, such as
/// the numbers and clauses of a table, which are set by who composes it. English texts come back as they are.
/// Bounded work: a text that fits thousands of ways stays English.
std::string translated(std::string_view text, Language language, const NumberStyle& numbers = {});

/// Whether translated() knows it: all of it, or numbers, symbols and units alone.
bool is_known(std::string_view text, Language language);

/// A value within a text that is no text: a symbol that is set already, words of the user. Only its number is known.
struct TextArgument {
  std::size_t number = 0;
  auto operator<=>(const TextArgument&) const = default;
};
using TextPiece = std::variant<std::string, TextArgument>;
using TextPieces = std::vector<TextPiece>;

/// A text with arguments, which fit the places of entries as a symbol does, never a word, pass through unread and go
/// where the other language puts them.
TextPieces translated(const TextPieces& text, Language language, const NumberStyle& numbers = {});
bool is_known(const TextPieces& text, Language language);

/// Every entry of a language, for tests.
std::span<const Phrase> phrases(Language language);

}  // namespace axiometry::language
