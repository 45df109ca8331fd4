// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/french.h"

#include <algorithm>
#include <array>

#include "axiometry/language/packed_text.h"

namespace axiometry::language {

namespace {

/// First letters that take an elision; of an h those that are mute in words of metrology.
constexpr auto elided =
    std::to_array<std::string_view>({"a", "e", "i", "o",       "u",    "y",     "à",    "â",     "ê",      "é",     "è",
                                     "î", "ô", "œ", "harmoni", "heur", "histo", "hori", "humid", "hypoth", "hystér"});

bool is_word(std::string_view content) {
  const auto follows = [&](std::size_t at) {
    const auto byte = static_cast<unsigned char>(at < content.size() ? content[at] : ' ');
    return (byte >= 'a' && byte <= 'z') || byte >= 0xC3;
  };
  return follows(content.starts_with('\xC3') || content.starts_with('\xC5') ? 2 : 1);  // neither "a =" nor "u_c"
}

bool takes_elision(std::string_view content) {
  return is_word(content) &&
         std::ranges::any_of(elided, [&](std::string_view letters) { return content.starts_with(letters); }) &&
         !content.starts_with("onz");
}

/// Whether the text ends with that word and a blank, and the word is not the end of a longer one.
bool ends_with_word(std::string_view text, std::string_view word) {
  if (!text.ends_with(' ') || !text.substr(0, text.size() - 1).ends_with(word)) return false;
  const std::size_t before = text.size() - 1 - word.size();
  if (before == 0) return true;
  const auto byte = static_cast<unsigned char>(text[before - 1]);
  return byte == ' ' || byte == '(' || byte == static_cast<unsigned char>(no_break) || byte == '\'';
}

/// What a preposition and an article, or what needs an article, become: "de le" → "du", "de axe X" → "de l’axe X".
struct Contraction {
  std::string_view word;
  std::string_view begins;
  std::string_view both;
};
constexpr Contraction contractions[] = {{"de", "le ", "du "},
                                        {"de", "les ", "des "},
                                        {"de", "ISO ", "de l’ISO "},
                                        {"de", "axe ", "de l’axe "},
                                        {"de", "diagonale ", "de la diagonale "},
                                        {"De", "le ", "Du "},
                                        {"De", "les ", "Des "},
                                        {"à", "le ", "au "},
                                        {"à", "les ", "aux "},
                                        {"à", "ISO ", "à l’ISO "},
                                        {"À", "le ", "Au "},
                                        {"À", "les ", "Aux "}};

/// What is named by a number has its article behind a preposition: "avant la ligne 137", but "ligne 137 : …".
struct Numbered {
  std::string_view noun;
  std::string_view article;
};
constexpr Numbered numbered[] = {{"ligne ", "la "},  {"lecture ", "la "}, {"point ", "le "},
                                 {"partie ", "la "}, {"cible ", "la "},   {"parcours ", "le "}};
constexpr std::string_view before_articles[] = {"avant", "Avant", "après", "Après", "pour", "Pour",
                                                "de",    "De",    "à",     "À",     "dans", "jusqu’à"};

std::string_view article_of(std::string_view text, std::string_view content) {
  const auto* found = std::ranges::find_if(numbered, [&](const Numbered& n) {
    return content.starts_with(n.noun) && content.size() > n.noun.size() && content[n.noun.size()] >= '0' &&
           content[n.noun.size()] <= '9';
  });
  const bool asked =
      std::ranges::any_of(before_articles, [&](std::string_view word) { return ends_with_word(text, word); });
  return found != std::end(numbered) && asked ? found->article : std::string_view();
}

constexpr std::array<std::string_view, 7> shortened = {"de", "De", "que", "le", "la", "Le", "La"};

}  // namespace

std::string with_french_spaces(std::string_view text) {
  std::string all;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != ' ') {
      all += text[k];
      continue;
    }
    const std::string_view next = text.substr(k + 1);
    const bool mark = !next.empty() && std::string_view(":;?!%").contains(next[0]) &&
                      (next.size() == 1 || std::string_view(" .,;)").contains(next[1]));
    const bool inside = next.starts_with("»") || text.substr(0, k).ends_with("«");
    all += mark || inside ? no_break_space : std::string_view(" ");
  }
  return all;
}

void append_in_french(std::string& text, std::string_view content) {
  if (const std::string_view article = article_of(text, content); !article.empty())
    return append_in_french(text, std::string(article) + std::string(content));
  for (const auto& [word, begins, both] : contractions) {
    if (!content.starts_with(begins) || !ends_with_word(text, word)) continue;
    text.resize(text.size() - word.size() - 1);
    text += both;
    text += content.substr(begins.size());
    return;
  }
  const auto word = std::ranges::find_if(shortened, [&](std::string_view w) { return ends_with_word(text, w); });
  if (word != shortened.end() && takes_elision(content)) {
    text.resize(text.size() - 2);  // its e or a, and the blank
    text += "’";
  }
  text += content;
}

const Grammar french_grammar = {
    .last_item = " et ", .clauses = "\x1f; ", .append = append_in_french, .set = with_french_spaces};

}  // namespace axiometry::language
