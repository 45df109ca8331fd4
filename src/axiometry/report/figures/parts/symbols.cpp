// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/symbols.h"

#include "axiometry/report/drawing/utf8.h"

namespace axiometry::report::plot {

TextRun plain(std::string_view text) { return {.text = std::string(text)}; }

TextRun italic(std::string_view text) { return {.text = std::string(text), .italic = true}; }

TextRun barred(std::string_view letter) { return {.text = std::string(letter), .italic = true, .bar = true}; }

TextRun index_letter(std::string_view letter) {
  return {.text = std::string(letter), .italic = true, .script = Script::sub};
}

TextRun index_number(std::size_t number) { return {.text = std::to_string(number), .script = Script::sub}; }

Runs symbol(const iso230_2::ParameterInfo& parameter) {
  constexpr std::string_view combining_macron = "\u0304";
  const std::string_view letter = parameter.symbol.substr(0, 1);
  const std::string_view rest = parameter.symbol.substr(1);
  if (rest.starts_with(combining_macron)) return {barred(letter)};
  if (rest.empty()) return {italic(letter)};
  return {italic(letter), plain(rest)};
}

Runs joined(Runs first, const Runs& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::string shortened(std::string_view text, double width, double size) {
  if (text_width({plain(text)}, size) <= width) return std::string(text);
  std::size_t end = 0;
  while (end < text.size()) {
    const std::size_t next = end + character_at(text, end).length;
    if (text_width({plain(text.substr(0, next)), plain("…")}, size) > width) break;
    end = next;
  }
  return std::string(text.substr(0, end)) + "…";
}

}  // namespace axiometry::report::plot
