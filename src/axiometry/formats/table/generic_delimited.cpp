// SPDX-License-Identifier: Apache-2.0
//
// The guess about a table of an unknown layout, and the format `generic` that reads after it.
#include "axiometry/formats/table/generic_delimited.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/table/generic_draft.h"
#include "axiometry/formats/table/guessed_read.h"

namespace axiometry::formats {
namespace {

using namespace generic;

constexpr std::size_t fewest_rows = 5;
constexpr std::size_t fewest_targets_of_runs = 3;  // in a wide table, whose names say more than those of a long one
constexpr std::size_t fewest_runs_across = 2;

void decide_text(Draft& draft, const DecodedText& decoded) {
  ImportProfile& profile = draft.guess.profile;
  const TableShape& shape = draft.shape;
  profile.encoding = TextEncoding::automatic;
  profile.delimiter = shape.rule.delimiter;
  profile.decimal_mark = shape.decimal_mark;
  profile.comment = shape.comment;
  profile.end = shape.end;
  draft.guess.questions = shape.questions;
  if (decoded.encoding != "UTF-8")
    draft.decide("encoding", std::string(decoded.encoding), 0.8, "the bytes are no UTF-8");
  draft.decide("delimiter", std::string(word_of(profile.delimiter)), 0.95,
               fmt::format("it parts {} into {}", counted(shape.row_count, "row"), counted(shape.columns, "column")));
  draft.decide("decimal_mark", profile.decimal_mark == ',' ? "comma" : "point", shape.rule.paired ? 0.6 : 0.95,
               shape.rule.paired  ? "between commas, as the header has half as many names as the rows have numbers"
               : !shape.mark_seen ? "no number has one"
                                  : "the numbers have it");
  if (!shape.end.empty())
    draft.decide("end", text::quoted(shape.end), 0.8, "what stands from there on is no row of the table");
}

/// Where the header is, or how many lines stand above the rows.
void decide_header(Draft& draft) {
  ImportProfile& profile = draft.guess.profile;
  const TableShape& shape = draft.shape;
  const bool named = std::ranges::any_of(profile.columns, [](const ImportColumn& c) { return !c.name.empty(); });
  if (profile.layout != TableLayout::transposed) profile.header_lines = shape.header_lines;
  if (!named) {
    profile.skip_lines = shape.first_line - 1;
    if (profile.skip_lines > 0)
      draft.decide("skip_lines", std::to_string(profile.skip_lines), 0.8, "rows of numbers begin behind them");
  }
  draft.decide("header_lines", std::to_string(profile.header_lines), 0.9,
               profile.header_lines == 0 ? "no line above the rows names their columns" : "names stand above the rows");
}

Result<Draft> draft_of(const DecodedText& decoded, std::span<const PlainLine> lines) {
  Draft draft;
  AXIOMETRY_TRY(draft.shape, find_shape(lines));
  const TableShape& shape = draft.shape;
  draft.facts = facts_of(shape);
  for (std::size_t c = 0; c < shape.columns; ++c) {
    Head head = shape.names.empty() ? Head{} : head_of(shape.names[c]);
    if (head.unit == nullptr && c < shape.units.size()) head.unit = shape.units[c];
    draft.heads.push_back(head);
  }
  draft.stated = read_lines_above(shape.above, AxisKind::linear, shape.decimal_mark).preamble.default_units;
  draft.guess.row_count = shape.row_count;
  draft.guess.first_line = shape.first_line;
  constexpr std::size_t shown = 12;
  draft.guess.preview.assign(shape.rows.begin(),
                             shape.rows.begin() + static_cast<std::ptrdiff_t>(std::min(shown, shape.rows.size())));
  decide_text(draft, decoded);
  return draft;
}

/// "Soll;1;2;3" above the rows has numbers as names of runs, so it was taken for a row.
void take_header_from_rows(Draft& draft) {
  TableShape& shape = draft.shape;
  if (!shape.names.empty() || shape.rows.size() < 2) return;
  const std::vector<ColumnFacts> below = facts_of(shape, 1);
  bool header = false;
  for (std::size_t c = 0; c < shape.columns; ++c) {
    const std::string& cell = shape.rows.front()[c];
    header = header ||
             (below[c].numeric() && !number_in(cell, shape.decimal_mark) && !is_missing(cell) && !is_bad_number(cell));
  }
  if (!header) return;
  shape.names = shape.rows.front();
  shape.rows.erase(shape.rows.begin());
  shape.row_lines.erase(shape.row_lines.begin());
  shape.header_lines = 1;
  --shape.row_count;
  ++shape.first_line;
  draft.facts = facts_of(shape);
  draft.heads.clear();
  for (const std::string& name : shape.names) draft.heads.push_back(head_of(name));
  draft.guess.row_count = shape.row_count;
  draft.guess.preview.erase(draft.guess.preview.begin());
}

/// Text where numbers must be, before anything is asked that follows from it.
Result<void> check_numbers(const Draft& draft) {
  const TableShape& shape = draft.shape;
  if (!draft.guess.questions.empty() && draft.guess.questions.front().key == "decimal_mark") return {};
  for (std::size_t r = 0; r < shape.rows.size(); ++r)
    for (std::size_t c = 0; c < shape.columns; ++c) {
      const ImportRole role = draft.guess.profile.columns[c].role;
      const bool reading = role == ImportRole::deviation || role == ImportRole::position;
      if (!reading && role != ImportRole::target) continue;
      if (reading && is_missing(shape.rows[r][c])) continue;
      if (number_in(shape.rows[r][c], shape.decimal_mark)) continue;
      AXIOMETRY_TRY(const std::vector<CsvCell> cells, cells_of(shape.row_lines[r], shape.rule));
      if (c < cells.size()) AXIOMETRY_TRY_VOID(number_at(cells[c], shape.decimal_mark, shape.row_lines[r].number));
    }
  return {};
}

/// Whether names give several columns of readings their runs or directions.
bool names_runs(const Draft& draft) {
  return std::ranges::count_if(draft.guess.profile.columns,
                               [](const ImportColumn& c) { return c.run || c.direction; }) > 1;
}

Result<Guess> guess_text(const DecodedText& decoded) {
  const std::vector<PlainLine> lines = lines_of(decoded.text);
  AXIOMETRY_TRY(Draft draft, draft_of(decoded, lines));
  const bool transposed = decide_transposed(draft);
  if (!transposed) take_header_from_rows(draft);
  const auto check_rows = [&](std::size_t fewest) -> Result<void> {
    if (draft.shape.row_count >= fewest) return {};
    return fail(fmt::format("found a table of {}, expected at least {}", counted(draft.shape.row_count, "row"), fewest),
                {draft.shape.first_line, 1});
  };
  if (transposed) {
    AXIOMETRY_TRY_VOID(check_rows(fewest_runs_across + 1));
  } else {
    draft.guess.names = draft.shape.names;
    draft.guess.profile.columns.assign(draft.shape.columns, {});
    for (std::size_t c = 0; c < draft.shape.names.size(); ++c) draft.column(c).name = draft.shape.names[c];
    decide_columns(draft);
    AXIOMETRY_TRY_VOID(check_rows(names_runs(draft) ? fewest_targets_of_runs : fewest_rows));
    AXIOMETRY_TRY_VOID(check_numbers(draft));
    decide_units(draft);
    decide_rules(draft);
  }
  decide_header(draft);
  std::ranges::stable_sort(draft.guess.decisions, {}, [](const GuessDecision& d) {
    return d.key.starts_with("columns") ? std::pair(d.key.size(), d.key) : std::pair(std::size_t{0}, std::string());
  });
  return std::move(draft.guess);
}

std::string told(const GuessDecision& question) {
  return fmt::format("found an open question, expected \"{}\" of an import profile to answer it: {}", question.key,
                     question.reason);
}

/// The decisions in few sentences: every one of them, and why.
std::vector<SourceRemark> remarks_of(const Guess& guess) {
  std::string columns;
  std::string others;
  for (const GuessDecision& d : guess.decisions) {
    std::string& list = d.key.starts_with("columns") ? columns : others;
    list += fmt::format("{}{}{} ({})", list.empty() ? "" : "; ", d.key.starts_with("columns") ? "" : d.key + " ",
                        d.value, d.reason);
  }
  return {{false, fmt::format("the columns were guessed: {}", columns)},
          {false, fmt::format("and so were: {}", others)}};
}

/// Whole lines only: the beginning of a file may be cut anywhere.
std::string_view whole_lines(std::string_view head) {
  constexpr std::size_t small = std::size_t{16} << 10;
  if (head.size() < small) return head;
  const std::size_t last = head.find_last_of("\r\n");
  return last == std::string_view::npos ? head : head.substr(0, last);
}

Result<Test> read(std::string_view bytes) { return read_guessed(bytes); }

int recognise(std::string_view head) {
  const auto found = guess(whole_lines(head));
  return found && found->questions.empty() ? 10 : 0;
}

constexpr std::string_view manual =
    R"(Any table of numbers in a text: what its columns mean is guessed, and every guess is told. Such as:

```
Messprotokoll Achse X
Datum: 4.5.2026

Lauf   Soll [mm]   Ist [mm]
1      0,000       0,0004
1      100,000     100,0011
1      200,000     200,0013
1      200,000     200,0021
1      100,000     100,0017
1      0,000       0,0009
```

- Delimiters: comma, semicolon, tab, blanks. Decimal point or comma. UTF-8, UTF-16, GBK, Windows-1252, Latin-1.
- Columns are known by their names in English, German, French, Italian, Spanish, Chinese and Japanese, or by their
  numbers: few values that come back are targets, numbers close to them measured positions, small ones deviations,
  whole ones from 0 or 1 runs. Units stand in the names, in a line below them, or above the table.
- One reading per row, one column per run, or one row per run with the targets across.
- The direction of approach stands in a column, in names of columns or labels of rows, or follows from the order of
  the targets: rows in the order of the measurement, or runs that go to and fro in turn.
- What cannot be known is asked, not assumed: the message names the member of an import profile that answers it.
  `axiometry convert FILE --guess --save-profile p.json` writes a profile to complete, `--profile p.json` reads after
  it, and `axiometry schema import-profile` says what may stand in it.
- What was guessed stands among the findings of every evaluation, and so do labels ↑ and ↓ that run the other way than
  the targets do, and deviations that are not measured minus target. Nothing is corrected.
- Refused: rows of different length, NaN, text in numbers, two decimal marks, more than 4096 columns or 64 MiB.
)";

}  // namespace

double Guess::confidence() const {
  if (!questions.empty() || decisions.empty()) return 0.0;
  return std::ranges::min(decisions, {}, &GuessDecision::confidence).confidence;
}

Result<Guess> guess(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decode(bytes, TextEncoding::automatic));
  return guess_text(decoded);
}

Result<Test> read_guessed(std::string_view bytes) {
  AXIOMETRY_TRY(const Guess found, guess(bytes));
  return read_guessed(found, bytes);
}

Result<Test> read_guessed(const Guess& found, std::string_view bytes) {
  if (!found.questions.empty()) return fail(told(found.questions.front()), {found.first_line, 0});
  AXIOMETRY_TRY(Test test, read_with(found.profile, bytes));
  std::vector<SourceRemark> remarks = remarks_of(found);
  std::ranges::move(test.provenance.remarks, std::back_inserter(remarks));
  test.provenance.remarks = std::move(remarks);
  return test;
}

Result<void> check_table(std::string_view head) {
  const std::string_view text = whole_lines(head);
  const auto found = guess(text);
  if (found && found->questions.empty()) return {};
  if (found) return fail(told(found->questions.front()), {1, 1});
  const auto decoded = decode(text, TextEncoding::automatic);
  if (found.error().at.line == 0 || !decoded || rows_of_table(lines_of(decoded->text)) < fewest_rows) return {};
  return std::unexpected(found.error());
}

Result<void> check_unit_believed(std::string_view head) {
  const auto found = guess(whole_lines(head));
  if (!found || found->profile.reading_unit == nullptr || found->questions.size() != 1) return {};
  const GuessDecision& question = found->questions.front();
  return question.key == "reading_unit" ? fail(told(question), {found->first_line, 0}) : Result<void>();
}

extern const Format generic_delimited_format;
const Format generic_delimited_format = {
    .id = any_table_format,
    .title = "Any table of numbers, by a guess",
    .extensions = ".txt .csv .dat",
    .manual = manual,
    .recognise = recognise,
    .read = read,
};

}  // namespace axiometry::formats
