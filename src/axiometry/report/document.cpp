// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/base/text/utf8.h"
#include "axiometry/base/version.h"

namespace axiometry::report {

namespace {

constexpr std::string_view combining_macron = "\u0304";

bool is_letter(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character.front());
  const bool ascii = (lead >= 'A' && lead <= 'Z') || (lead >= 'a' && lead <= 'z');
  return ascii || lead == 0xCE || lead == 0xCF;  // the Greek block, as in θ and α
}

/// Letters that count or name a coordinate, as in x_ij and e_x; the c of p_c and the eff of ν_eff are words cut short.
bool counts_something(std::string_view index) {
  return std::ranges::all_of(index, [](char c) { return std::string_view("hijkmnxyz").contains(c); });
}

/// Appends runs of equal style, letters in italics if asked for, a letter before U+0304 with a bar.
void append(RichText& runs, std::string_view text, bool italic_letters, Script script) {
  while (!text.empty()) {
    const std::string_view character = text.substr(0, character_at(text, 0).length);
    text.remove_prefix(character.size());
    const bool bar = text.starts_with(combining_macron);
    if (bar) text.remove_prefix(combining_macron.size());
    const bool italic = italic_letters && is_letter(character);
    const bool continues =
        !runs.empty() && !bar && !runs.back().bar && runs.back().italic == italic && runs.back().script == script;
    if (!continues) runs.push_back({.text = {}, .italic = italic, .bar = bar, .script = script});
    runs.back().text += character;
  }
}

constexpr std::string_view decimal_digits = "0123456789";

std::string_view without_sign(std::string_view text) {
  for (std::string_view sign : {"\u2212", "-", "+"})
    if (text.starts_with(sign)) return text.substr(sign.size());
  return text;
}

/// Whether one letter that begins a word stands before the underscore, as in U_EVE but not in axis_name.
bool is_symbol_root(std::string_view text, std::size_t underscore) {
  constexpr std::string_view openers = " (/";
  if (underscore == 0 || !is_letter(text.substr(underscore - 1))) return false;
  return underscore == 1 || openers.find(text[underscore - 2]) != std::string_view::npos;
}

/// Where an index ends: before a blank, a bracket or a slash, and before the punctuation there.
std::size_t end_of_index(std::string_view text, std::size_t start) {
  std::size_t end = std::min(text.find_first_of(" /()", start), text.size());
  while (end > start && std::string_view(".,;:").find(text[end - 1]) != std::string_view::npos) --end;
  return end;
}

}  // namespace

std::string program_text() { return fmt::format("Axiometry {}", version); }

RichText plain(std::string_view text) { return {TextRun{.text = std::string(text)}}; }

RichText strong(std::string_view text) { return {TextRun{.text = std::string(text), .bold = true}}; }

RichText italic(std::string_view text) { return {TextRun{.text = std::string(text), .italic = true}}; }

RichText verbatim(std::string_view text) { return {TextRun{.text = std::string(text), .verbatim = true}}; }

RichText symbol(std::string_view text) {
  const std::size_t underscore = std::min(text.find('_'), text.size());
  const std::string_view index = text.substr(std::min(underscore + 1, text.size()));
  const std::size_t arrow = std::min({index.find("↑"), index.find("↓"), index.size()});
  const bool counts = counts_something(index.substr(0, arrow));  // x_ij: of reading j at target i
  RichText runs;
  append(runs, text.substr(0, underscore), true, Script::normal);
  append(runs, counts ? index.substr(0, arrow) : index, counts, Script::sub);
  if (counts) append(runs, index.substr(arrow), false, Script::normal);
  return runs;
}

RichText prose(std::string_view text) {
  RichText runs;
  std::size_t done = 0;
  for (std::size_t at = text.find('_'); at != std::string_view::npos; at = text.find('_', at + 1)) {
    const std::size_t end = end_of_index(text, at + 1);
    if (!is_symbol_root(text, at) || end == at + 1) continue;
    runs = joined({runs, plain(text.substr(done, at - 1 - done)), symbol(text.substr(at - 1, end - at + 1))});
    done = end;
  }
  return joined({runs, plain(text.substr(done))});
}

RichText sentence(std::string_view message) {
  std::string text(message);
  const bool ends = text.ends_with('.') || text.ends_with('?') || text.ends_with('!');
  if (!text.empty() && !ends) text += '.';
  const auto small = [&](std::size_t k) { return k < text.size() && text[k] >= 'a' && text[k] <= 'z'; };
  const bool word = (small(0) && small(1)) || (text.starts_with("a ") && small(2) && small(3));  // "a gain", no symbol
  if (word) text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return prose(text);
}

RichText joined(std::initializer_list<RichText> parts) {
  RichText all;
  for (const RichText& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::string plain_text(const RichText& text) {
  std::string all;
  for (const TextRun& run : text) {
    all += run.text;
    if (run.bar) all += combining_macron;
  }
  return all;
}

void put_label(Document& document, std::string label) {
  document.label = std::move(label);
  if (document.label.empty()) return;
  document.status.insert(document.status.begin(), {Tone::caution, plain("Label: " + document.label), {}});
}

bool is_number(std::string_view text) {
  const std::string_view magnitude = without_sign(text);
  return !magnitude.empty() && decimal_digits.find(magnitude.front()) != std::string_view::npos &&
         magnitude.find_first_not_of("0123456789.,") == std::string_view::npos;
}

std::size_t fraction_length(std::string_view number) {
  if (!is_number(number)) return 0;
  return number.size() - std::min(number.find_last_of(".,"), number.size());
}

std::size_t longest_fraction(const Table& table, std::size_t column) {
  std::size_t longest = 0;
  for (const auto& row : table.rows) longest = std::max(longest, fraction_length(plain_text(row[column].text)));
  return longest;
}

}  // namespace axiometry::report
