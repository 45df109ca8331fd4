// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/language.h"

namespace axiometry::language {

std::optional<Language> language_of(std::string_view tag) {
  const std::string_view primary = tag.substr(0, tag.find('-'));
  if (primary == "en") return Language::english;
  if (primary == "de") return Language::german;
  return {};
}

std::string_view tag(Language language) { return language == Language::german ? "de" : "en"; }

Language best_of(std::string_view accept_language) {
  return language_of(accept_language.substr(0, accept_language.find_first_of(",;"))).value_or(Language::english);
}

std::string translated(std::string_view text, Language, const NumberStyle&) { return std::string(text); }

}  // namespace axiometry::language
