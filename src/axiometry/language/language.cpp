// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/language.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/text.h"
#include "axiometry/language/french.h"
#include "axiometry/language/phrase_book.h"
#include "axiometry/language/phrase_file.h"
#include "axiometry/language/phrase_reader.h"

namespace axiometry::language {
namespace {

const Grammar german_grammar = {.last_item = " und ", .nouns_are_capital = true};

struct Known {
  Language language;
  std::string_view tag;
  std::string_view own_name;
  char decimal_mark;
  const Grammar* grammar;  ///< absent of English, which is not looked up
};

/// In the order of the values of Language.
constexpr auto known = std::to_array<Known>({{Language::english, "en", "English", '.', nullptr},
                                             {Language::german, "de", "Deutsch", ',', &german_grammar},
                                             {Language::french, "fr", "Français", ',', &french_grammar}});

const Known& known_of(Language language) { return known[static_cast<std::size_t>(language)]; }

/// Made at the first use, so that it costs nothing where it is not asked for. Contract: not English, which needs none.
const PhraseBook& book_of(Language language) {
  AXIOMETRY_CONTRACT(language != Language::english);
  static std::array<std::once_flag, known.size()> made;
  static std::array<std::optional<PhraseBook>, known.size()> books;
  const auto number = static_cast<std::size_t>(language);
  std::call_once(made[number], [&] { books[number].emplace(pairs_of(known[number].tag), *known[number].grammar); });
  return *books[number];
}

/// Contract: a text without arguments.
std::string words_of(const TextPieces& text) {
  std::string all;
  for (const TextPiece& piece : text) {
    AXIOMETRY_CONTRACT(std::holds_alternative<std::string>(piece));
    all += std::get<std::string>(piece);
  }
  return all;
}

/// The weight of "de;q=0.7": 1 where none is given, 0 where it is none.
double weight_of(std::string_view parameters) {
  for (const std::string_view part : text::split(parameters, ';')) {
    const std::string_view parameter = text::trim(part);
    if (parameter.starts_with("q=") || parameter.starts_with("Q="))
      return std::clamp(parse_number(parameter.substr(2)).value_or(0.0), 0.0, 1.0);
  }
  return 1.0;
}

}  // namespace

std::optional<Language> language_of(std::string_view tag) {
  const std::string primary = text::to_lower(tag.substr(0, tag.find('-')));
  const auto found = std::ranges::find(known, primary, &Known::tag);
  return found == known.end() ? std::nullopt : std::optional(found->language);
}

Result<Language> chosen_language(std::string_view tag) {
  if (const auto language = language_of(tag)) return *language;
  return fail(fmt::format("found the language {}, expected one of {}", text::quoted(tag), tags_of_languages()));
}

std::span<const Language> languages() {
  static constexpr auto all = [] {
    std::array<Language, known.size()> found{};
    std::ranges::transform(known, found.begin(), &Known::language);
    return found;
  }();
  return all;
}

std::string_view tag(Language language) { return known_of(language).tag; }
std::string_view own_name(Language language) { return known_of(language).own_name; }

std::string tags_of_languages() {
  std::string all;
  for (const Known& each : known) all.append(all.empty() ? "" : ", ").append(each.tag);
  return all;
}

NumberStyle usual_numbers(Language language) { return {.decimal_mark = known_of(language).decimal_mark}; }

Language best_of(std::string_view accept_language) {
  Language best = Language::english;
  double weight = 0.0;
  for (const std::string_view part : text::split(accept_language, ',')) {
    const std::size_t end = std::min(part.find(';'), part.size());
    const std::string_view range = text::trim(part.substr(0, end));
    const auto language = range == "*" ? std::optional(Language::english) : language_of(range);
    const double q = weight_of(part.substr(end));
    if (!language || q <= weight) continue;
    best = *language;
    weight = q;
  }
  return best;
}

std::string translated(std::string_view text, Language language, const NumberStyle& numbers) {
  if (language == Language::english) return std::string(text);
  return words_of(PhraseReader(book_of(language), numbers).read({std::string(text)}).text);
}

TextPieces translated(const TextPieces& text, Language language, const NumberStyle& numbers) {
  return language == Language::english ? text : PhraseReader(book_of(language), numbers).read(text).text;
}

bool is_known(std::string_view text, Language language) { return is_known(TextPieces{std::string(text)}, language); }

bool is_known(const TextPieces& text, Language language) {
  return language == Language::english || PhraseReader(book_of(language), {}).read(text).known;
}

std::span<const Phrase> phrases(Language language) {
  return language == Language::english ? std::span<const Phrase>{} : book_of(language).phrases();
}

}  // namespace axiometry::language
