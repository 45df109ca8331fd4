// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/formats/text/units.h"
#include "axiometry/model/axis.h"

/// The words, numbers and units of conformance cases (check.h); private to app/.
namespace axiometry::app {

struct Word {
  std::string_view text;  ///< the word without quotes
  TextPosition at;
  bool quoted = false;

  bool is(std::string_view plain) const { return !quoted && text == plain; }
};

/// One line without its comment. Words are separated by blanks; "…" holds one word together; = < > <= >=
/// stand by themselves with or without blanks around them.
struct Statement {
  std::string_view text;  ///< the whole line, trimmed
  std::vector<Word> words;
  TextPosition end;  ///< just behind the last word, for "expected …" that is missing

  /// Where the word of this index stands, or would.
  TextPosition at(std::size_t index) const { return index < words.size() ? words[index].at : end; }
};

/// Fails on a quotation mark without its partner.
Result<Statement> read_statement(std::string_view line, std::size_t number);

/// Fails, naming the word, when it is no number.
Result<double> read_number(const Statement& statement, std::size_t index);

/// Unit of deviations. Fails on a unit of the other kind of axis and on no unit at all.
Result<const formats::Unit*> read_deviation_unit(const Statement& statement, std::size_t index, AxisKind kind);

/// The kind of axis that a unit of targets tells: mm or deg.
Result<AxisKind> read_position_unit(const Statement& statement, std::size_t index);

/// "found "x", expected y" at the word of this index; "found the end of the line, …" behind the last.
std::unexpected<Error> unexpected_word(const Statement& statement, std::size_t index, std::string_view expected);

}  // namespace axiometry::app
