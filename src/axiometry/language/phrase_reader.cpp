// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/phrase_reader.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "axiometry/language/packed_text.h"
#include "axiometry/language/words.h"

namespace axiometry::language {
namespace {

constexpr int deepest = 7;
constexpr std::size_t longest = 6000;               // bytes: no text that the program composes is longer
constexpr std::size_t length_of_argument = 3;       // bytes: of a sign, as its mark in a packed text
constexpr std::size_t least_literal_of_rough = 12;  // bytes: a shorter one fits by accident

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

/// Sentences end in ". " before a capital letter, a bracket or a symbol, as "g" and "p_c".
std::vector<std::string_view> sentences(std::string_view text) {
  std::vector<std::string_view> all;
  std::size_t start = 0;
  for (std::size_t at = text.find(". "); at != std::string_view::npos; at = text.find(". ", at + 1)) {
    const char next = at + 2 < text.size() ? text[at + 2] : 'a';
    const bool symbol = at + 3 < text.size() && is_lower(next) && (text[at + 3] == ' ' || text[at + 3] == '_');
    if (!is_upper(next) && next != '(' && static_cast<unsigned char>(next) < 0x80 && !symbol) continue;
    all.push_back(text.substr(start, at + 1 - start));
    start = at + 2;
  }
  all.push_back(text.substr(start));
  return all;
}

/// Coarse ones first.
constexpr std::string_view separators[] = {"\n", "; ", " · ", ", ", " and "};

std::string_view in_grammar(std::string_view separator, const Grammar& grammar) {
  if (separator == " and ") return grammar.last_item;
  return separator == "; " ? grammar.clauses : separator;
}

/// "C0Y", "X", "A_up" at the front of a text, up to the first character that no symbol has; nothing where a word of two
/// letters or more stands there, which may begin a sentence.
std::string_view symbol_in_front(std::string_view text) {
  const auto in_symbol = [](char c) { return is_upper(c) || is_lower(c) || (c >= '0' && c <= '9') || c == '_'; };
  std::size_t length = 0;
  while (length < text.size() && in_symbol(text[length])) ++length;
  const bool is_word = length > 1 && (is_lower(text[1]) || is_upper(text[1]));
  return is_word ? std::string_view() : text.substr(0, length);
}

/// A text was looked up with the first letter of another case. Where what was found begins with the symbol of the text,
/// taken over as it was asked for, that gets its own case back.
std::string with_symbol_of(std::string_view text, std::string_view asked, std::string found) {
  const std::string_view symbol = symbol_in_front(asked);
  if (!symbol.empty() && symbol_in_front(found) == symbol) found[0] = text[0];
  return found;
}

/// Whether every bracket that is opened is closed, and none before.
bool is_balanced(std::string_view text) {
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')' && --depth < 0) return false;
  }
  return depth == 0;
}

/// Parted where the separator stands outside of brackets.
std::vector<std::string_view> items(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> all;
  std::size_t start = 0;
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '(') ++depth;
    if (text[at] == ')') --depth;
    if (depth > 0 || at < start || !text.substr(at).starts_with(separator)) continue;
    all.push_back(text.substr(start, at - start));
    start = at + separator.size();
  }
  all.push_back(text.substr(start));
  return all;
}

std::size_t length_of(const TextPieces& text) {
  std::size_t length = 0;
  for (const TextPiece& piece : text) {
    const auto* words = std::get_if<std::string>(&piece);
    length += words != nullptr ? words->size() : length_of_argument;
  }
  return length;
}

}  // namespace

PhraseReader::Answer PhraseReader::read(const TextPieces& text) {
  if (length_of(text) > longest) return {text, false};
  const PackedText all(text);
  if (has_no_words(all.text())) return {text, true};
  if (const auto found = known(all.text(), 0)) return {all.unpacked(*found), true};
  return {all.unpacked(roughly(all.text())), false};
}

bool PhraseReader::works(std::size_t bytes) {
  work_left_ -= static_cast<long>(bytes);
  return work_left_ > 0;
}

PhraseReader::Found PhraseReader::known(std::string_view text, int depth) {
  if (depth > deepest || !works(text.size())) return std::nullopt;
  if (has_no_words(text)) return with_decimal_mark(text, numbers_.decimal_mark);
  if (is_quoted(text)) return std::string(text);
  if (const auto literal = book_.literal(with_blanks(text))) return packed(*literal);
  if (auto found = by_sentence(text, depth)) return found;  // before patterns, which would try them all for the rest
  const bool is_sentence = is_upper(text.front()) && text.back() == '.';
  if (is_sentence)
    if (auto found = variant(text, depth)) return found;
  if (auto found = whole(text, depth)) return found;
  if (!is_sentence)
    if (auto found = variant(text, depth)) return found;
  return by_item(text, depth);
}

PhraseReader::Found PhraseReader::whole(std::string_view text, int depth) {
  const std::string blanks = with_blanks(text);
  if (const auto literal = book_.literal(blanks)) return packed(*literal);
  for (const Pattern* pattern : book_.candidates(blanks.front()))
    if (auto found = set(*pattern, blanks, text, depth, true)) return found;
  return std::nullopt;
}

PhraseReader::Found PhraseReader::variant(std::string_view text, int depth) {
  const bool stop = text.size() > 1 && text.back() == '.';
  std::string inner(stop ? text.substr(0, text.size() - 1) : text);
  const auto ended = [&](std::string found) { return stop ? found + "." : found; };
  if (is_upper(inner[0])) {
    // "Found … ." is a phrase that begins small; as it stands it could only fit one that begins with a place.
    std::string small = inner;
    small[0] = static_cast<char>(inner[0] - 'A' + 'a');
    if (stop)
      if (const auto literal = book_.literal(with_blanks(inner))) return ended(packed(*literal));
    if (auto found = whole(small, depth)) return ended(capitalised(with_symbol_of(text, small, *std::move(found))));
  }
  if (stop)
    if (auto found = whole(inner, depth)) return ended(*std::move(found));
  if (is_lower(inner[0])) {
    inner[0] = static_cast<char>(inner[0] - 'a' + 'A');
    if (auto found = whole(inner, depth)) {
      std::string own = with_symbol_of(text, inner, *std::move(found));
      return ended(book_.grammar().nouns_are_capital ? std::move(own) : without_capital(std::move(own)));
    }
  }
  return std::nullopt;
}

PhraseReader::Found PhraseReader::by_sentence(std::string_view text, int depth) {
  const auto parts = sentences(text);
  if (parts.size() < 2) return std::nullopt;
  std::string all;
  for (const std::string_view part : parts) {
    auto found = known(part, depth + 1);
    if (!found) return std::nullopt;
    all += (all.empty() ? "" : " ") + *found;
  }
  return all;
}

PhraseReader::Found PhraseReader::by_item(std::string_view text, int depth) {
  for (const std::string_view separator : separators) {
    const auto parts = items(text, separator);
    if (parts.size() < 2) continue;
    std::string all;
    std::size_t done = 0;
    while (done < parts.size()) {  // an item may hold the separator itself: as few parts as make one
      Found found;
      std::size_t next = done;
      for (constexpr std::size_t most = 3; !found && next < std::min(parts.size(), done + most); ++next) {
        const std::string_view joined(
            parts[done].data(), static_cast<std::size_t>(parts[next].data() + parts[next].size() - parts[done].data()));
        if (!joined.empty() && joined.size() < text.size()) found = known(joined, depth + 1);
      }
      if (!found) break;
      if (done > 0) all += in_grammar(separator, book_.grammar());
      all += *found;
      done = next;
    }
    if (done == parts.size()) return all;
  }
  return std::nullopt;
}

bool PhraseReader::fits(const Pattern& pattern, const std::string& blanks, std::size_t piece, std::size_t at,
                        Captures& captures) {
  if (!works(1)) return false;
  const Pattern::Place& place = pattern.places[piece];
  const std::string& next = pattern.literals[piece + 1];
  const bool last = piece + 1 == pattern.places.size();
  const std::size_t least = place.kind == PlaceKind::optional_text ? 0 : 1;
  const auto take = [&](std::size_t end) {
    if (end < at + least || cuts_argument(blanks, end)) return false;
    if (place.kind == PlaceKind::amount && !has_no_words(std::string_view(blanks).substr(at, end - at))) return false;
    if (place.kind == PlaceKind::text && !is_balanced(std::string_view(blanks).substr(at, end - at))) return false;
    captures[place.number] = {at, end - at};
    return last || fits(pattern, blanks, piece + 1, end + next.size(), captures);
  };
  if (last) return blanks.size() >= at + next.size() && take(blanks.size() - next.size());
  for (std::size_t end = blanks.find(next, at + least); end != std::string::npos && works(1);
       end = blanks.find(next, end + 1))
    if (take(end)) return true;
  return false;
}

PhraseReader::Found PhraseReader::set(const Pattern& pattern, const std::string& blanks, std::string_view packed_text,
                                      int depth, bool strict) {
  if (!blanks.starts_with(pattern.first()) || !blanks.ends_with(pattern.last())) return std::nullopt;
  if (blanks.size() < pattern.literal_length) return std::nullopt;
  Captures captures{};
  if (!works(blanks.size()) || !fits(pattern, blanks, 0, pattern.first().size(), captures)) return std::nullopt;
  std::array<std::string, Captures{}.size()> contents;
  for (const Pattern::Place& place : pattern.places) {
    const auto [at, length] = captures[place.number];
    const std::string_view content = packed_text.substr(at, length);
    if (length == 0 || place.kind == PlaceKind::verbatim) {
      contents[place.number] = content;
      continue;
    }
    auto found = known(content, depth + 1);
    if (!found && strict) return std::nullopt;
    contents[place.number] = found ? *std::move(found) : std::string(content);
  }
  std::string all;
  const std::string other = packed(pattern.phrase->other);
  for (std::size_t k = 0; k < other.size(); ++k) {
    const bool is_place = other[k] == '{' && k + 2 < other.size() && other[k + 2] == '}';
    if (!is_place) {
      all += other[k];
      continue;
    }
    const auto number = static_cast<std::size_t>(other[k + 1] - '0');
    const bool stays = std::ranges::any_of(pattern.places, [&](const Pattern::Place& place) {
      return place.number == number && place.kind == PlaceKind::verbatim;
    });
    if (stays || book_.grammar().append == nullptr)
      all += contents[number];
    else
      book_.grammar().append(all, contents[number]);
    k += 2;
  }
  return all;
}

std::string PhraseReader::sentence_or_part(std::string_view text) {
  if (auto found = known(text, 1)) return *std::move(found);
  const bool stop = text.ends_with('.');
  const bool upper = !text.empty() && is_upper(text[0]);
  std::string inner(stop ? text.substr(0, text.size() - 1) : text);
  for (const bool lowered : {false, true}) {
    if (lowered && !upper) break;
    if (lowered) inner[0] = static_cast<char>(inner[0] - 'A' + 'a');
    const std::string blanks = with_blanks(inner);
    if (blanks.empty()) break;
    for (const Pattern* pattern : book_.candidates(blanks.front())) {
      if (pattern->literal_length < least_literal_of_rough) break;
      if (auto found = set(*pattern, blanks, inner, 0, false))
        return (lowered ? capitalised(with_symbol_of(text, inner, *std::move(found))) : *std::move(found)) +
               (stop ? "." : "");
    }
  }
  return std::string(text);
}

std::string PhraseReader::roughly(std::string_view text) {
  std::string all;
  for (const std::string_view part : sentences(text)) all += (all.empty() ? "" : " ") + sentence_or_part(part);
  return all;
}

}  // namespace axiometry::language
