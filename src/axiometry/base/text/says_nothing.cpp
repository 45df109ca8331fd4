// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/text/says_nothing.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/text/text.h"
#include "axiometry/base/text/utf8.h"

namespace axiometry::text {
namespace {

using WordList = std::span<const std::string_view>;

/// Without blanks, hyphens and low lines, as squeezed() has them.
constexpr std::string_view nothing_words[] = {
    "n/a", "n\\a", "na", "n.a", "n.n", "nan", "null", "unknown", "notknown", "unk", "unidentified", "unspecified",
    "notspecified", "undefined", "notdefined", "tbd", "t.b.d", "tba", "tbc", "todo", "notstated", "unstated",
    "notgiven", "notprovided", "notindicated", "notreported", "notrecorded", "notentered", "notavailable",
    "unavailable", "notapplicable", "noinformation", "noinfo", "nodata", "nostatement", "nothing", "nothingstated",
    "missing", "empty", "blank", "placeholder", "xx", "xxx", "xxxx",
    // German
    "unbekannt", "nichtbekannt", "n.b", "nichtangegeben", "nichtgenannt", "nichterfasst", "nichtermittelt",
    "nichtvorhanden", "nichtverfügbar", "nichtzutreffend", "trifftnichtzu", "entfällt", "keineangabe", "keineangaben",
    "ohneangabe", "ohneangaben", "k.a", "k/a", "o.a", "o.ang", "fehlt", "leer", "offen", "nichts", "nichtanwendbar",
    // French
    "inconnu", "inconnue", "nonconnu", "nonconnue", "nonindiqué", "nonindiquée", "nonprécisé", "nonprécisée",
    "nonspécifié", "nonspécifiée", "nonrenseigné", "nonrenseignée", "nondéfini", "nondéfinie", "nondéterminé",
    "nondéterminée", "noncommuniqué", "noncommuniquée", "nondisponible", "indisponible", "nonapplicable", "sansobjet",
    "s.o", "s/o", "n.c", "n/c", "n.d", "n/d", "n.r", "n/r", "àdéfinir", "àpréciser", "àcompléter", "vide", "manquant",
    "manquante", "rien"};

constexpr std::string_view none_words[] = {
    "none", "nil", "notused", "unused", "notdone", "notmade", "notcarriedout", "notperformed", "notexecuted",
    "notfitted", "notpresent", "absent", "omitted", "skipped", "without",
    // German
    "kein", "keine", "keiner", "keines", "keinen", "keinem", "keins", "ohne", "nichtbenutzt", "nichtverwendet",
    "nichtgenutzt", "unbenutzt", "nichtgemacht", "nichtdurchgeführt", "nichterfolgt", "nichtausgeführt", "ausgelassen",
    "weggelassen", "unterlassen",
    // French
    "aucun", "aucune", "aucuns", "aucunes", "néant", "sans", "nul", "nulle", "nonutilisé", "nonutilisée", "inutilisé",
    "inutilisée", "nonfait", "nonfaite", "noneffectué", "noneffectuée", "nonréalisé", "nonréalisée", "omis", "omise",
    "absente"};

constexpr std::string_view no_words[] = {
    "no", "off", "0", "not", "false", "switchedoff", "turnedoff", "disabled", "inactive", "notactive", "deactivated",
    // German
    "nein", "aus", "nicht", "inaktiv", "nichtaktiv", "ausgeschaltet", "abgeschaltet", "deaktiviert",
    // French
    "non", "inactif", "inactive", "désactivé", "désactivée", "arrêt", "éteint", "éteinte"};

constexpr std::string_view cold_words[] = {"cold",      "coldstart",    "fromcold", "machinecold", "kalt",
                                           "kaltstart", "ausdemkalten", "àfroid",   "froid",       "machinefroide"};

/// A refusal is the first word of these, and then what was not done: "no load, 30 min" is a warm-up.
constexpr std::string_view refusing[] = {"no",    "not",  "without", "kein",   "keine", "ohne",
                                         "nicht", "sans", "aucun",   "aucune", "pas",   "non"};
constexpr std::string_view between[] = {"a", "any", "the", "de", "un", "une"};
constexpr std::string_view of_warming[] = {"warm",    "preheat",   "aufwärm", "aufgewärm", "anwärm", "erwärm",
                                           "einlauf", "préchauff", "échauff", "chauff",    "mise",   "montée"};

/// Dashes, spaces and marks beyond ASCII.
bool is_mark(char32_t code) {
  return (code >= 0x80 && code <= 0xBF) || code == 0xD7 || (code >= 0x2000 && code <= 0x206F) || code == 0x2212 ||
         (code >= 0x3000 && code <= 0x303F) || code == 0xFF0D || code == 0xFEFF;
}

/// "É" as "é": of U+00C0 to U+00DE, which take two bytes of UTF-8.
std::string small_letter(std::string_view character, char32_t code) {
  std::string small = to_lower(character);
  if (code >= 0xC0 && code <= 0xDE) small[1] = static_cast<char>(small[1] + 0x20);
  return small;
}

/// In small letters, without blanks, hyphens, low lines and marks beyond ASCII, and without marks at its ends.
std::string squeezed(std::string_view s) {
  std::string all;
  for (std::size_t at = 0; at < s.size();) {
    if (const char c = s[at]; c > ' ' && c < '\x7F') {  // most are, and need no text of their own
      if (c != '-' && c != '_') all += c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
      ++at;
      continue;
    }
    const Character character = character_at(s, at);
    const bool between_words = character.code <= ' ' || character.code == '-' || character.code == '_';
    if (!between_words && !is_mark(character.code)) all += small_letter(s.substr(at, character.length), character.code);
    at += character.length;
  }
  constexpr std::string_view marks = "()[]{}<>\"'.,;:!?*/\\|=~+#";
  const std::size_t begin = all.find_first_not_of(marks);
  return begin == all.npos ? "" : all.substr(begin, all.find_last_not_of(marks) + 1 - begin);
}

bool is_among(std::string_view word, WordList words) { return std::ranges::find(words, word) != words.end(); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// "0", "0 min", "0.0 h": an amount without a digit but 0.
bool is_zero_amount(std::string_view word) {
  return !word.empty() && word.front() == '0' &&
         std::ranges::none_of(word, [](char c) { return is_digit(c) && c != '0'; });
}

bool refuses_warming(std::string_view s) {
  std::vector<std::string_view> rest = words(s);
  if (rest.size() < 2 || !is_among(to_lower(rest[0]), refusing)) return false;
  rest.erase(rest.begin());
  if (is_among(to_lower(rest[0]), between)) rest.erase(rest.begin());
  if (rest.empty()) return false;
  const std::string what = squeezed(rest[0]);
  return std::ranges::any_of(of_warming, [&](std::string_view stem) { return what.starts_with(stem); });
}

}  // namespace

bool says_nothing(std::string_view s) {
  const std::string word = squeezed(s);
  return word.empty() || is_among(word, nothing_words);
}

bool says_none(std::string_view s) { return is_among(squeezed(s), none_words); }

bool says_no(std::string_view s) { return says_none(s) || is_among(squeezed(s), no_words); }

bool says_no_warm_up(std::string_view s) {
  const auto none = [](std::string_view part) {
    const std::string word = squeezed(part);
    return says_no(part) || is_zero_amount(word) || is_among(word, cold_words) || refuses_warming(part);
  };
  if (none(s)) return true;
  bool any = false;  // "cold start, no warm-up": all of its parts say so
  for (std::size_t begin = 0; begin < s.size();) {
    const std::size_t end = std::min(s.find_first_of(",;()", begin), s.size());
    const std::string_view part = s.substr(begin, end - begin);
    begin = end + 1;
    if (squeezed(part).empty()) continue;
    if (!none(part)) return false;
    any = true;
  }
  return any;
}

}  // namespace axiometry::text
