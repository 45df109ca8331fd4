// SPDX-License-Identifier: Apache-2.0
//
// CSV with one column per run, and one row per target or per target and direction.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_preamble.h"
#include "axiometry/formats/csv/csv_values.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/series/series_order.h"
#include "axiometry/formats/series/target_index.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/thousands.h"

namespace axiometry::formats {
namespace csv_wide {
namespace {

using Directions = std::array<std::size_t, 2>;

struct RunColumn {
  std::size_t column = 0;
  std::optional<Direction> direction;  ///< none when a column of its own tells it
  std::size_t run = 0;                 ///< index j − 1
};

struct WideLayout {
  std::size_t target = 0;
  std::optional<std::size_t> direction;
  std::vector<RunColumn> runs;
  std::size_t run_count = 0;
  const Unit* target_unit = nullptr;
  ReadingRule rule;
};

Result<void> refuse_long_columns(const Preamble& preamble) {
  for (const Column& c : preamble.columns)
    if (c.role == ColumnRole::test || c.role == ColumnRole::run)
      return fail(
          fmt::format("found the column {} in a file with one column per run, expected target, direction and runs only",
                      text::quoted(c.name)),
          {preamble.header_line, c.at_column});
  return {};
}

std::string_view spelled(std::optional<Direction> direction) {
  if (!direction) return "";
  return direction == Direction::up ? "↑" : "↓";
}

/// Columns without a number count themselves: "up, up, down, down".
Result<std::vector<RunColumn>> run_columns(const Preamble& preamble, bool direction_column) {
  std::vector<RunColumn> runs;
  std::map<std::pair<int, std::size_t>, std::size_t> taken;
  Directions unnumbered{};
  for (std::size_t c = 0; c < preamble.columns.size(); ++c) {
    const Column& column = preamble.columns[c];
    if (column.role != ColumnRole::reading) continue;
    const TextPosition at{preamble.header_line, column.at_column};
    if (direction_column && column.direction)
      return fail(fmt::format("found the column {} beside a direction column, expected the direction in one of them",
                              text::quoted(column.name)),
                  at);
    if (!direction_column && !column.direction)
      return fail(
          fmt::format("found the column {} without a direction, expected up or down in its name or a direction column",
                      text::quoted(column.name)),
          at);
    const int d = column.direction ? static_cast<int>(*column.direction) : 0;
    std::size_t run = 0;
    if (column.run) {
      AXIOMETRY_TRY(run, run_number(std::to_string(*column.run), at));
    } else {
      run = ++unnumbered[static_cast<std::size_t>(d)];
    }
    const auto [first, inserted] = taken.try_emplace({d, run}, c);
    if (!inserted)
      return fail(fmt::format("found the columns {} and {} for one run, expected one of them",
                              text::quoted(preamble.columns[first->second].name), text::quoted(column.name)),
                  at);
    runs.push_back({c, column.direction, run - 1});
  }
  return runs;
}

Result<WideLayout> layout_of(Preamble& preamble) {
  const std::size_t line = preamble.header_line;
  AXIOMETRY_TRY_VOID(check_columns(preamble.columns, preamble.default_units, line));
  AXIOMETRY_TRY_VOID(refuse_long_columns(preamble));
  WideLayout layout;
  AXIOMETRY_TRY(const auto target, only_column(preamble.columns, ColumnRole::target, line));
  AXIOMETRY_TRY(layout.direction, only_column(preamble.columns, ColumnRole::direction, line));
  AXIOMETRY_TRY(layout.runs, run_columns(preamble, layout.direction.has_value()));
  if (layout.runs.empty())
    return fail("found no columns of runs, expected some such as up1_um and down1_um", {line, 1});
  layout.target = *target;
  layout.target_unit = preamble.columns[*target].unit;
  const Column& first = preamble.columns[layout.runs.front().column];
  layout.rule = {first.measured, first.unit};
  for (const RunColumn& run : layout.runs) layout.run_count = std::max(layout.run_count, run.run + 1);
  AXIOMETRY_TRY_VOID(
      placed(check_grid({.targets = 1, .runs = layout.run_count, .readings = layout.runs.size()}), {line, 1}));
  return layout;
}

/// Gathers rows into targets and readings.
class WideRows {
 public:
  WideRows(const Preamble& preamble, WideLayout layout)
      : preamble_(preamble), layout_(std::move(layout)), numbers_(preamble.delimiter) {}

  Result<void> add(const std::vector<CsvCell>& cells, std::size_t line) {
    const CsvCell& target_cell = cells[layout_.target];
    AXIOMETRY_TRY(const double x, numbers_.read(target_cell.text, {line, target_cell.column}));
    thousands_.look_at(0, target_cell.text);
    const Position target = position_in(*layout_.target_unit, x);
    falling_ = falling_ && (targets_.empty() || target.in_native() < targets_.back().in_native());
    std::optional<Direction> direction;
    if (layout_.direction) {
      const CsvCell& cell = cells[*layout_.direction];
      direction = direction_from(cell.text);
      if (!direction)
        return fail(fmt::format("found {}, expected a direction: {}", text::quoted(cell.text), direction_words),
                    {line, cell.column});
    }
    AXIOMETRY_TRY(const std::size_t i, enter_row(target, direction, {line, target_cell.column}));
    for (const RunColumn& run : layout_.runs) {
      const CsvCell& cell = cells[run.column];
      if (is_missing(cell.text)) continue;
      const TextPosition at{line, cell.column};
      AXIOMETRY_TRY(const double value, numbers_.read(cell.text, at));
      thousands_.look_at(1, cell.text);
      const auto d = static_cast<std::size_t>(run.direction ? *run.direction : *direction);
      AXIOMETRY_TRY(readings_[i][d * layout_.run_count + run.run],
                    placed(native_deviation(layout_.rule, target, value), at));
      ++reading_count_;
    }
    return {};
  }

  Result<Series> series() {
    const TextPosition header{preamble_.header_line, 1};
    if (targets_.empty())
      return fail(
          fmt::format("found no readings below the header on line {}, expected one row per target", header.line));
    const auto doubt = preamble_.delimiter == ',' ? std::nullopt : thousands_.found();  // as in csv-long
    if (doubt) return fail(thousands_fault(*doubt), header);
    const std::size_t m = targets_.size();
    std::vector<double> deviations;
    deviations.reserve(2 * m * layout_.run_count);
    for (std::size_t d = 0; d < 2; ++d)
      for (const auto& row : readings_)
        deviations.insert(deviations.end(), row.begin() + static_cast<std::ptrdiff_t>(d * layout_.run_count),
                          row.begin() + static_cast<std::ptrdiff_t>((d + 1) * layout_.run_count));
    AXIOMETRY_TRY(Series series,
                  placed(sorted_series(std::move(targets_), layout_.run_count, std::move(deviations)), header));
    if (layout_.rule.measured == Measured::deviation)
      AXIOMETRY_TRY_VOID(placed(check_deviations(series, layout_.rule.unit->kind), header));
    return series;
  }

  std::optional<char> mark() const { return numbers_.mark(); }

  /// Whether every row's target is below that of the row before.
  bool targets_fall() const { return falling_ && lines_.size() > 1; }

 private:
  /// Index of the target; a row that was there before is refused.
  Result<std::size_t> enter_row(Position target, std::optional<Direction> direction, TextPosition at) {
    auto entry = numbers_of_targets_.lower_bound(target.in_native() - same_target);
    const bool is_new = entry == numbers_of_targets_.end() || entry->first > target.in_native() + same_target;
    if (is_new) entry = numbers_of_targets_.emplace(target.in_native(), targets_.size()).first;
    const std::size_t i = entry->second;
    if (is_new) {
      AXIOMETRY_TRY_VOID(placed(check_grid({.targets = targets_.size() + 1,
                                            .runs = layout_.run_count,
                                            .readings = reading_count_ + layout_.runs.size()}),
                                at));
      targets_.push_back(target);
      readings_.emplace_back(2 * layout_.run_count, std::numeric_limits<double>::quiet_NaN());
      lines_.push_back({});
    }
    std::size_t& line = lines_[i][static_cast<std::size_t>(direction.value_or(Direction::up))];
    if (line != 0)
      return fail(fmt::format("found a second row of target {}{}, expected only that on line {}",
                              format_exact(target.in_native()), spelled(direction), line),
                  at);
    line = at.line;
    return i;
  }

  const Preamble& preamble_;
  WideLayout layout_;
  NumberReader numbers_;
  ThousandsDoubt thousands_{2};  // of targets and readings
  std::map<double, std::size_t> numbers_of_targets_;
  std::vector<Position> targets_;
  std::vector<Directions> lines_;              // of the rows of each target; 0 before they come
  std::vector<std::vector<double>> readings_;  // per target: all runs up, then all runs down
  std::size_t reading_count_ = 0;
  bool falling_ = true;
};

Result<void> take_row(WideRows& rows, const Preamble& preamble, std::string_view line, std::size_t number,
                      bool cut_off) {
  if (line.starts_with('#') || line.starts_with("\"#")) {
    AXIOMETRY_TRY(const bool metadata, is_metadata_line(line, number));
    if (!metadata) return {};
    return fail(fmt::format("found metadata below the header, expected it above line {}", preamble.header_line),
                {number, 1});
  }
  AXIOMETRY_TRY(const std::vector<CsvCell> cells, split_row(line, preamble.delimiter, number));
  AXIOMETRY_TRY_VOID(check_cell_count(cells, {.expected = preamble.columns.size(),
                                              .needed = needed_columns(preamble.columns),
                                              .header_line = preamble.header_line,
                                              .line = number,
                                              .delimiter = preamble.delimiter,
                                              .cut_off = cut_off}));
  if (std::ranges::all_of(cells, [](const CsvCell& c) { return c.text.empty(); })) return {};
  return rows.add(cells, number);
}

/// A column of a run whose name says forward or back rather than up or down: nothing where all say the latter.
const Column* named_by_order(const Preamble& preamble) {
  constexpr std::string_view words[] = {"forward",  "fwd",  "hin",   "vor",       "vorwärts",   "vorwaerts",
                                        "backward", "back", "bwd",   "rev",       "reverse",    "zurück",
                                        "zurueck",  "rück", "rueck", "rückwärts", "rueckwaerts"};
  for (const Column& column : preamble.columns)
    if (column.role == ColumnRole::reading && column.direction) {
      const std::string name = text::to_lower(column.name);
      for (const std::string_view word : words)
        if (name.contains(word)) return &column;
    }
  return nullptr;
}

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  std::string_view text = decoded.text;
  AXIOMETRY_TRY(Preamble preamble, read_preamble(text));
  if (preamble.columns.empty()) return fail("found no header, expected a line that names the columns");
  AXIOMETRY_TRY(WideLayout layout, layout_of(preamble));
  const AxisKind kind = layout.target_unit->kind;
  WideRows rows(preamble, std::move(layout));
  text.remove_prefix(preamble.size);
  for (std::size_t number = preamble.header_line + 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const bool cut_off = end == text.size();
    if (!text::trim(line).empty()) AXIOMETRY_TRY_VOID(take_row(rows, preamble, line, number, cut_off));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  AXIOMETRY_TRY(Series series, rows.series());
  AXIOMETRY_TRY(Metadata metadata,
                metadata_of(preamble, kind, rows.mark().value_or(preamble.delimiter == ',' ? '.' : ',')));
  Test test{std::move(metadata), std::move(series), {}};
  test.provenance.remarks = encoding_remarks(decoded);
  test.provenance.remarks.insert(test.provenance.remarks.end(), preamble.remarks.begin(), preamble.remarks.end());
  if (auto passed_over = passed_over_text(preamble.columns))
    test.provenance.remarks.push_back({false, *std::move(passed_over)});
  if (rows.targets_fall())
    if (const Column* column = named_by_order(preamble))
      test.provenance.remarks.push_back(
          {false, fmt::format("the targets fall from row to row, and the column {} is named for an order: forward was "
                              "taken as ↑, towards growing positions; where it means along the rows, both directions "
                              "are exchanged",
                              text::quoted(column->name))});
  return test;
}

/// One row per target; directions without any reading have no columns.
std::string write(const Test& test) {
  const bool linear = test.metadata.axis.kind == AxisKind::linear;
  const Series& series = test.series;
  std::string text = metadata_lines(test) + (linear ? "target_mm" : "target_deg");
  const auto for_each_run = [&](auto act) {
    for (const Direction direction : {Direction::up, Direction::down})
      for (std::size_t j = 0; series.has(direction) && j < series.run_count(); ++j) act(direction, j);
  };
  for_each_run([&](Direction direction, std::size_t j) {
    text += fmt::format(",{}{}_{}", direction == Direction::up ? "up" : "down", j + 1, linear ? "um" : "arcsec");
  });
  text += '\n';
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    text += format_exact(series.targets()[i].in_native());
    for_each_run([&](Direction direction, std::size_t j) {
      const auto reading = series.reading(i, direction, j);
      text += "," + (reading ? format_exact(reading->in_native()) : std::string());
    });
    text += '\n';
  }
  return text;
}

int recognise(std::string_view head) {
  bool target = false;
  bool runs = false;
  bool directions = false;
  for (const Column& c : header_columns(head)) {
    target |= c.role == ColumnRole::target;
    runs |= c.role == ColumnRole::reading && (c.run || c.direction);
    directions |= c.role == ColumnRole::direction || (c.role == ColumnRole::reading && c.direction);
  }
  if (!target || !runs) return 0;
  return directions ? 95 : 9;  // numbers alone may be targets across the table
}

constexpr std::string_view manual = R"(Delimited text, one column per run. Either one row per target:

```
target_mm,up1_um,up2_um,down1_um,down2_um
0,0.1,0.2,0.9,0.8
250,0.4,0.4,1.1,1.2
```

or one row per target and direction:

```
target_mm,direction,run1_um,run2_um
0,up,0.1,0.2
0,down,0.9,0.8
```

- The name of a run holds its direction (up, down, ↑, ↓, forward, backward, reverse, or a sign at its end as in `1+`)
  and its number, in any order: `up1_um`, `↑1 (µm)`, `run 1 up [um]`, `3-_um`. Columns without a number count
  themselves. `measured 1 up_mm` and `position 1 up_mm` hold measured positions.
- All runs have one unit. Units, delimiters, decimal marks, missing readings, ignored columns and metadata lines
  are as in csv-long.
- Refused: a target or a run given twice, ragged rows, mixed units, NaN and infinite numbers.
)";

}  // namespace
}  // namespace csv_wide

extern const Format csv_wide_format;
const Format csv_wide_format = {
    .id = "csv-wide",
    .title = "CSV, one column per run",
    .extensions = ".csv .txt .tsv",
    .manual = csv_wide::manual,
    .recognise = csv_wide::recognise,
    .read = csv_wide::read,
    .write = csv_wide::write,
};

}  // namespace axiometry::formats
