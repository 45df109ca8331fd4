// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/formats/table/import_profile.h"
#include "axiometry/model/test.h"

/// Tables of numbers that no format describes: read after a profile, or after a guess that says what it took for what.
/// Both are pure; nothing is read that a profile or a guess does not account for.
namespace axiometry::formats {

/// The id of the format that reads any table.
inline constexpr std::string_view any_table_format = "generic";

/// One thing that a guess has decided, or could not decide.
struct GuessDecision {
  std::string key;          ///< member of the profile: "direction", "columns[1].role"
  std::string value;        ///< what it was taken for, in words; for a question: empty
  double confidence = 0.0;  ///< 0 to 1: how sure, by judgement and not by any statistics
  std::string reason;       ///< why; for a question: what was found and which answers there are
};

struct Guess {
  ImportProfile profile;
  std::vector<GuessDecision> decisions;
  std::vector<GuessDecision> questions;  ///< what only the user knows; while there are any, nothing is read
  std::size_t row_count = 0;
  std::size_t first_line = 0;                     ///< line of the file where the rows begin
  std::vector<std::string> names;                 ///< names of the columns; empty without a header
  std::vector<std::vector<std::string>> preview;  ///< the first rows

  /// The least of all decisions; 0 while there are questions.
  double confidence() const;
};

/// What kind of table the file holds. Looks at words in the header (head_words.h), at units, and at the numbers: a
/// column that repeats few values is the target, one close to it the measured position, a small one a deviation, one
/// that counts the run. Fails, with the place, when there is no table of numbers with two columns and five rows (two
/// rows in a transposed one), when rows differ in length, when numbers have two decimal marks, and as generic::decode()
/// does.
Result<Guess> guess(std::string_view bytes);

/// Reads after a profile. `provenance.remarks` holds what a reader must know: text that was not UTF-8, labels ↑ and ↓
/// that run the other way than the targets do, deviations that are not measured minus target. Fails, with line and
/// column, on whatever the profile does not account for: rows of another length, text in numbers, NaN, words that are
/// no direction, a reading given twice, names of columns that are not those of the profile; and, naming the member, on
/// what the profile leaves open.
Result<Test> read_with(const ImportProfile& profile, std::string_view bytes);

/// guess(), then read_with(), and every decision in the remarks. Fails with the first question where there is one.
Result<Test> read_guessed(std::string_view bytes);

/// Why a file that no format recognises is not read as a table: with the first question of the guess, or with what in
/// it is no row of the rest. Passes where there is no table of five rows, which says nothing.
Result<void> check_table(std::string_view head);

/// Why a table whose columns are all known is not read: the unit that it states for its readings is one that its
/// numbers speak against. Passes on all else, which says nothing.
Result<void> check_unit_believed(std::string_view head);

}  // namespace axiometry::formats
