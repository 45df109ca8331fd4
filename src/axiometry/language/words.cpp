// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/words.h"

#include <algorithm>
#include <array>
#include <functional>

namespace axiometry::language {
namespace {

constexpr auto wordless = std::to_array<std::string_view>(
    {"ANSI", "API",   "ASME",   "Axiometry", "CSV", "Ciddor", "DEG",     "DEVICE", "DIN",     "EN",
     "EVE",  "Edlén", "GUM",    "HTML",      "IEC", "ISO",    "JCGM",    "JSON",   "MACHINE", "MISALIGNMENT",
     "MPE",  "NC",    "NDE",    "PDF",       "PNG", "SHA",    "STATION", "SVG",    "Student", "TOOL",
     "UTC",  "VDI",   "arcsec", "deg",       "hPa", "kPa",    "km",      "mK",     "mbar",    "min",
     "mm",   "ms",    "nm",     "ppm",       "um",  "µm",     "µrad"});

static_assert(std::ranges::is_sorted(wordless));

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Bytes of the letters of Latin-1 and Latin Extended-A (U+00C0 to U+017F); µ (U+00B5) counts as one of "µm".
std::size_t letter_length(std::string_view text) {
  if (text.empty()) return 0;
  if (is_ascii_letter(text[0])) return 1;
  const auto lead = static_cast<unsigned char>(text[0]);
  if (text.size() < 2) return 0;
  const auto next = static_cast<unsigned char>(text[1]);
  if (lead == 0xC3 && next != 0x97 && next != 0xB7) return 2;  // not × and ÷
  if (lead == 0xC4 || lead == 0xC5 || (lead == 0xC2 && next == 0xB5)) return 2;
  return 0;
}

/// "EYX", "ECZ": an error of ISO 230-1, whatever the language.
bool is_error_symbol(std::string_view word) {
  constexpr std::string_view axes = "XYZ", coordinates = "XYZABC";
  return word.size() == 3 && word[0] == 'E' && coordinates.contains(word[1]) && axes.contains(word[2]);
}

bool is_symbol(std::string_view word, std::size_t letters) {
  return letters == 1 || is_error_symbol(word) || std::ranges::binary_search(wordless, word);
}

/// Between two digits, and not one of several marks as in "5.3.2".
bool is_decimal_point(std::string_view text, std::size_t at) {
  if (at == 0 || at + 1 >= text.size() || !is_digit(text[at - 1]) || !is_digit(text[at + 1])) return false;
  std::size_t first = at, last = at + 1;
  while (first > 0 && is_digit(text[first - 1])) --first;
  while (last < text.size() && is_digit(text[last])) ++last;
  const bool follows =
      first > 0 && (text[first - 1] == '.' || text[first - 1] == '_' || is_ascii_letter(text[first - 1]));
  const bool goes_on = last + 1 < text.size() && text[last] == '.' && is_digit(text[last + 1]);
  return !follows && !goes_on;
}

/// "−0,577", "12", one mark at most.
bool is_coordinate(std::string_view text) {
  constexpr std::string_view minus = "\u2212";
  if (text.starts_with(minus)) text.remove_prefix(minus.size());
  const auto digits_or_mark = [](char c) { return is_digit(c) || c == ',' || c == '.'; };
  return !text.empty() && is_digit(text.front()) && is_digit(text.back()) &&
         std::ranges::all_of(text, digits_or_mark) && std::ranges::count_if(text, std::not_fn(is_digit)) <= 1;
}

/// "0,5, −1, 2,25": what stands between the brackets of a place or of a direction.
bool is_coordinates(std::string_view text) {
  constexpr std::string_view separator = ", ";
  if (!text.contains(separator)) return false;
  for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    if (!is_coordinate(text.substr(0, end))) return false;
    text.remove_prefix(end + separator.size());
  }
  return is_coordinate(text);
}

/// A comma cannot both end whole numbers and part coordinates: "(0,5, 1)" → "(0,5; 1)".
void part_coordinates(std::string& text) {
  for (std::size_t open = text.find('('); open != std::string::npos; open = text.find('(', open + 1)) {
    const std::size_t close = text.find(')', open);
    if (close == std::string::npos) return;
    if (!is_coordinates(std::string_view(text).substr(open + 1, close - open - 1))) continue;
    for (std::size_t at = text.find(", ", open); at < close; at = text.find(", ", at)) text[at] = ';';
  }
}

}  // namespace

bool has_no_words(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t length = letter_length(text.substr(at));
    if (length == 0) {
      ++at;
      continue;
    }
    const std::size_t start = at;
    std::size_t letters = 0;
    for (; length > 0; length = letter_length(text.substr(at))) {
      at += length;
      ++letters;
    }
    const bool index = start >= 2 && text[start - 1] == '_';  // as in U_EVE, x_ij
    const bool exponent = start > 0 && is_digit(text[start - 1]) && letters == 1;
    if (!index && !exponent && !is_symbol(text.substr(start, at - start), letters)) return false;
  }
  return true;
}

std::string with_decimal_mark(std::string_view text, char mark) {
  std::string all(text);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (text[k] == '.' && is_decimal_point(text, k)) all[k] = mark;
  if (mark == ',') part_coordinates(all);
  return all;
}

bool is_quoted(std::string_view text) {
  if (text.size() < 2 || (text.front() != '\'' && text.front() != '"')) return false;
  return text.find(text.front(), 1) == text.size() - 1;
}

namespace {

/// Whether a letter in front is that of a word and no symbol (s_i, u = …): another follows, or an apostrophe as in
/// "l’axe", or it is the French "à".
bool begins_word(std::string_view text, std::string_view rest) {
  return letter_length(rest) > 0 || rest.starts_with("’") || text.starts_with("à ") || text.starts_with("À ");
}

}  // namespace

std::string capitalised(std::string text) {
  const std::size_t first = letter_length(text);
  if (first == 0 || !begins_word(text, std::string_view(text).substr(first))) return text;
  if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  const bool accented = text[0] == '\xC3' && static_cast<unsigned char>(text[1]) >= 0xA0;
  if (accented && static_cast<unsigned char>(text[1]) != 0xBF) text[1] = static_cast<char>(text[1] - 0x20);
  if (text.starts_with("œ")) text[1] = '\x92';
  return text;
}

std::string without_capital(std::string text) {
  const std::size_t first = letter_length(text);
  const std::string_view rest = std::string_view(text).substr(first);
  if (first == 0 || !begins_word(text, rest) || (rest[0] >= 'A' && rest[0] <= 'Z')) return text;  // U_EVE, NDE
  if (text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
  const auto accented = static_cast<unsigned char>(text[0] == '\xC3' ? text[1] : 0);
  if (accented >= 0x80 && accented < 0x9F && accented != 0x97) text[1] = static_cast<char>(accented + 0x20);
  return text;
}

}  // namespace axiometry::language
