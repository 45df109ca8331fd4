// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/language.h"

#include <algorithm>

#include "axiometry/base/text.h"
#include "axiometry/language/german.h"
#include "axiometry/language/phrase_book.h"
#include "axiometry/language/reader.h"

namespace axiometry::language {
namespace {

/// Made at the first use, so that it depends on no order of initialisation.
const PhraseBook& german() {
  static const PhraseBook book(german_tables());
  return book;
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
  if (primary == "en") return Language::english;
  if (primary == "de") return Language::german;
  return {};
}

std::string_view tag(Language language) { return language == Language::german ? "de" : "en"; }

NumberStyle usual_numbers(Language language) { return {.decimal_mark = language == Language::german ? ',' : '.'}; }

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
  return Reader(german(), numbers).read(text).text;
}

bool is_known(std::string_view text, Language language) {
  return language == Language::english || Reader(german(), {}).read(text).known;
}

std::span<const Phrase* const> phrases(Language language) {
  return language == Language::german ? german().phrases() : std::span<const Phrase* const>{};
}

}  // namespace axiometry::language
