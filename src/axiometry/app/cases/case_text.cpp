// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/cases/case_text.h"

#include <fmt/format.h>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

bool blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool relation(char c) { return c == '=' || c == '<' || c == '>'; }

/// Length of the word that begins the text, which begins with no blank.
std::size_t word_length(std::string_view rest) {
  if (relation(rest[0])) return rest.size() > 1 && rest[0] != '=' && rest[1] == '=' ? 2 : 1;
  std::size_t n = 1;
  while (n < rest.size() && !blank(rest[n]) && !relation(rest[n]) && rest[n] != '#' && rest[n] != '"') ++n;
  return n;
}

}  // namespace

Result<Statement> read_statement(std::string_view line, std::size_t number) {
  Statement statement;
  std::size_t i = 0;
  while (i < line.size() && line[i] != '#') {
    const TextPosition at{number, i + 1};
    if (blank(line[i])) {
      ++i;
      continue;
    }
    if (line[i] == '"') {
      const std::size_t close = line.find('"', i + 1);
      if (close == line.npos) return fail("found a quotation mark without its partner, expected \"…\"", at);
      statement.words.push_back({line.substr(i + 1, close - i - 1), at, true});
      i = close + 1;
      continue;
    }
    const std::size_t length = word_length(line.substr(i));
    statement.words.push_back({line.substr(i, length), at, false});
    i += length;
  }
  statement.text = text::trim(line.substr(0, i));
  statement.end = {number, i + 1};
  return statement;
}

std::unexpected<Error> unexpected_word(const Statement& statement, std::size_t index, std::string_view expected) {
  const std::string found =
      index < statement.words.size() ? text::quoted(statement.words[index].text) : std::string("the end of the line");
  return fail(fmt::format("found {}, expected {}", found, expected), statement.at(index));
}

Result<double> read_number(const Statement& statement, std::size_t index) {
  if (index < statement.words.size())
    if (const auto x = parse_number(statement.words[index].text)) return *x;
  return unexpected_word(statement, index, "a number");
}

Result<const formats::Unit*> read_deviation_unit(const Statement& statement, std::size_t index, AxisKind kind) {
  if (index < statement.words.size())
    if (const formats::Unit* unit = formats::find_unit(statement.words[index].text); unit && unit->kind == kind)
      return unit;
  return unexpected_word(statement, index,
                         kind == AxisKind::linear ? "the unit um, mm or nm" : "the unit arcsec or deg");
}

Result<AxisKind> read_position_unit(const Statement& statement, std::size_t index) {
  if (index < statement.words.size()) {
    const Word& word = statement.words[index];
    if (word.is("mm")) return AxisKind::linear;
    if (word.is("deg") || word.is("°")) return AxisKind::rotary;
  }
  return unexpected_word(statement, index, "the unit mm or deg");
}

}  // namespace axiometry::app
