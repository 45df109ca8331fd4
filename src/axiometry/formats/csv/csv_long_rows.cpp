// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/csv_long_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/fixed_point.h"
#include "axiometry/formats/series/series_order.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t reading_limit = 20'000'000;  // most readings of one test; 480 MB

bool is_native(const Unit& unit, std::string_view linear, std::string_view rotary) {
  return unit.name == linear || unit.name == rotary;
}

std::string arrow(std::uint8_t direction) { return direction == 0 ? "↑" : "↓"; }

}  // namespace

Result<LongLayout> long_layout(Preamble& preamble) {
  const std::size_t line = preamble.header_line;
  std::vector<Column>& columns = preamble.columns;
  AXIOMETRY_TRY_VOID(check_columns(columns, preamble.default_units, line));
  const auto required = [&](ColumnRole role, std::string_view name) -> Result<std::size_t> {
    AXIOMETRY_TRY(const auto column, only_column(columns, role, line));
    if (!column)
      return fail(fmt::format("found no {} column, expected target, direction, run and deviation", name), {line, 1});
    return *column;
  };
  LongLayout layout;
  AXIOMETRY_TRY(layout.target, required(ColumnRole::target, "target"));
  AXIOMETRY_TRY(layout.direction, required(ColumnRole::direction, "direction"));
  AXIOMETRY_TRY(layout.run, only_column(columns, ColumnRole::run, line));
  AXIOMETRY_TRY(layout.reading, required(ColumnRole::reading, "deviation"));
  AXIOMETRY_TRY(layout.test, only_column(columns, ColumnRole::test, line));
  layout.target_unit = columns[layout.target].unit;
  layout.rule = {columns[layout.reading].measured, columns[layout.reading].unit};
  layout.kind = layout.target_unit->kind;
  if (layout.rule.measured == Measured::position) return layout;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].role != ColumnRole::ignored || columns[c].measured != Measured::position) continue;
    const Unit* unit = columns[c].unit != nullptr ? columns[c].unit : layout.target_unit;
    if (unit->kind != layout.kind) continue;
    layout.beside = c;
    layout.rule_beside = {Measured::position, unit};
    break;
  }
  return layout;
}

LongRows::LongRows(Preamble preamble, LongLayout layout, NamedTestSink sink, Path path)
    : preamble_(std::move(preamble)),
      layout_(layout),
      sink_(std::move(sink)),
      path_(path),
      numbers_(preamble_.delimiter),
      native_targets_(is_native(*layout.target_unit, "mm", "deg")),
      native_readings_(layout.rule.measured == Measured::deviation && is_native(*layout.rule.unit, "um", "arcsec")),
      rows_repeat_(layout.test == 0u && layout.reading + 1 == preamble_.columns.size()),
      line_(preamble_.header_line) {
  for (const Column& column : preamble_.columns) roles_.push_back(column.role);
  told_ = preamble_.remarks;
  if (auto passed_over = passed_over_text(preamble_.columns)) told_.push_back({false, *std::move(passed_over)});
}

Result<void> LongRows::take(std::string_view lines, const char* readable_end) {
  // Behind a last line without a line break stands anything, so it takes no short cut.
  const std::size_t whole = lines.rfind('\n') + 1;
  const char* p = lines.data();
  const char* const end = p + whole;
  while (p < end) {
    ++line_;
    const char* next = doubts_thousands() ? nullptr : repeated_row(p, readable_end);
    if (next == nullptr && !doubts_thousands()) next = plain_row(p, readable_end);
    if (next == nullptr) {
      next = static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end - p))) + 1;
      AXIOMETRY_TRY_VOID(general_row({p, next}));
    }
    p = next;
  }
  if (whole == lines.size()) return {};
  ++line_;
  return general_row(lines.substr(whole));
}

Result<void> LongRows::finish() {
  if (in_test_) return end_test();
  return fail(
      fmt::format("found no readings below the header on line {}, expected one per line", preamble_.header_line));
}

/// As long as marks may part thousands, numbers are looked at as they are written. Between commas a point parts none.
bool LongRows::doubts_thousands() const {
  constexpr std::size_t enough_rows = 20'000;
  return preamble_.delimiter != ',' && !thousands_.settled() && rows_doubted_ < enough_rows;
}

int LongRows::mark() const { return numbers_.mark() ? *numbers_.mark() : no_decimal_mark; }

namespace {

/// Behind the line break, or null when none stands here.
const char* line_break_at(const char* p) {
  p += *p == '\r';
  return *p == '\n' ? p + 1 : nullptr;
}

}  // namespace

// The row that repeats one of the test before, but for the reading. Null without having done anything otherwise.
const char* LongRows::repeated_row(const char* p, const char* readable_end) {
  if (!rows_repeat_ || path_ == Path::general_only || !in_test_ || readings_.size() >= reading_limit) return nullptr;
  const std::size_t begin_size = row_begin_.size();
  if (static_cast<std::size_t>(readable_end - p) < begin_size + RowMemory::longest + fixed_point_reach) return nullptr;
  if (!same_bytes(p, row_begin_.data(), begin_size)) return nullptr;
  const std::size_t k = readings_.size();
  const PlainRow* before = memory_.recall(k, p + begin_size);
  if (before == nullptr) return nullptr;
  const FixedPoint number = read_fixed_point(p + begin_size + memory_.size_of(k), mark());
  if (number.end == nullptr) return nullptr;
  const char* next = line_break_at(number.end);
  PlainRow row = *before;
  row.reading = number.value;
  return next != nullptr && add_plain(row) ? next : nullptr;
}

// The row that needs no care: adds its reading and returns the byte behind it, or null without having done anything.
const char* LongRows::plain_row(const char* p, const char* readable_end) {
  if (path_ == Path::general_only || !in_test_ || readings_.size() >= reading_limit) return nullptr;
  PlainRow row;
  const char* const begin = p;
  const char* last_cell = p;
  for (std::size_t c = 0; c < roles_.size(); ++c) {
    if (static_cast<std::size_t>(readable_end - p) < fixed_point_reach + test_name_.size()) return nullptr;
    last_cell = p;
    p = plain_cell(p, roles_[c], mark(), row);
    if (p == nullptr) return nullptr;
    if (c + 1 < roles_.size() && *p++ != preamble_.delimiter) return nullptr;
  }
  const char* next = line_break_at(p);
  if (next == nullptr || !add_plain(row)) return nullptr;
  if (rows_repeat_) memory_.remember(readings_.size() - 1, {begin + row_begin_.size(), last_cell}, row);
  return next;
}

const char* LongRows::plain_cell(const char* p, ColumnRole role, int mark, PlainRow& row) const {
  switch (role) {
    case ColumnRole::reading: {
      const FixedPoint number = read_fixed_point(p, mark);
      row.reading = number.value;
      return number.end;
    }
    case ColumnRole::target: {
      const FixedPoint number = read_fixed_point(p, mark);
      row.target = number.value;
      return number.end;
    }
    case ColumnRole::direction: {
      const std::uint64_t word = detail::load_little_endian(p);
      for (std::uint8_t d = 0; d < 2; ++d) {
        if (labels_[d].size == 0 || (word & labels_[d].mask) != labels_[d].bytes) continue;
        row.direction = d;
        return p + labels_[d].size;
      }
      return nullptr;
    }
    case ColumnRole::run: {
      const detail::Digits digits = detail::digits_of_block(p);
      if (digits.count == 0 || digits.value == 0 || digits.value > read_budget::runs) return nullptr;
      row.run = static_cast<std::uint16_t>(digits.value - 1);
      return p + digits.count;
    }
    case ColumnRole::test:
      return std::memcmp(p, test_name_.data(), test_name_.size()) == 0 ? p + test_name_.size() : nullptr;
    case ColumnRole::ignored:
    case ColumnRole::unknown: break;
  }
  return nullptr;  // an ignored column may hold anything
}

bool LongRows::add_plain(const PlainRow& row) {
  double target = row.target;
  double deviation = row.reading;
  if (!native_targets_) target = position_in(*layout_.target_unit, target).in_native();
  if (!native_readings_) {
    const auto converted = native_deviation(layout_.rule, Position::native(target), deviation);
    if (!converted) return false;
    deviation = *converted;
  }
  if (!(std::abs(deviation) <= largest_stated)) return false;
  RowReading reading{deviation, line_, targets_.number(target), row.run, row.direction};
  if (!layout_.run) {
    std::size_t& approaches = approaches_to(reading);
    if (approaches >= read_budget::runs) return false;
    reading.run = static_cast<std::uint16_t>(approaches++);
  }
  readings_.push_back(reading);
  return true;
}

Result<void> LongRows::general_row(std::string_view line) {
  const bool cut_off = !line.ends_with('\n');
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  const std::string_view content = text::trim(line);
  if (content.empty()) return {};
  AXIOMETRY_TRY_VOID(check_utf8(line, line_));
  if (content.starts_with('#') || content.starts_with("\"#")) return comment_row(line);
  AXIOMETRY_TRY(const std::vector<CsvCell> cells, split_row(line, preamble_.delimiter, line_));
  AXIOMETRY_TRY_VOID(check_cell_count(cells, {.expected = preamble_.columns.size(),
                                              .needed = needed_columns(preamble_.columns),
                                              .header_line = preamble_.header_line,
                                              .line = line_,
                                              .delimiter = preamble_.delimiter,
                                              .cut_off = cut_off}));
  // Spreadsheets fill blank rows with delimiters.
  if (std::ranges::all_of(cells, [](const CsvCell& c) { return c.text.empty(); })) return {};
  if (layout_.test) {
    const CsvCell& name = cells[*layout_.test];
    AXIOMETRY_TRY_VOID(enter_test(name.text, {line_, name.column}));
  } else if (!in_test_) {
    AXIOMETRY_TRY_VOID(enter_test({}, {line_, 1}));
  }
  return add_cells(cells);
}

Result<void> LongRows::comment_row(std::string_view line) {
  AXIOMETRY_TRY(const bool metadata, is_metadata_line(line, line_));
  // A row of a test "#3" must not be taken for a comment, and a comment is not refused for nothing.
  const auto cells = split_row(line, preamble_.delimiter, line_);
  if (layout_.test == 0u && cells && cells->size() == roles_.size())
    return fail("found a row that begins with #, expected names of tests that do not", {line_, 1});
  if (!metadata) return {};
  return fail(fmt::format("found metadata below the header, expected it above line {}", preamble_.header_line),
              {line_, 1});
}

Result<void> LongRows::enter_test(std::string_view name, TextPosition at) {
  if (in_test_ && name == test_name_) return {};
  if (layout_.test && name.empty()) return fail("found an empty test name, expected one in every row", at);
  if (in_test_) AXIOMETRY_TRY_VOID(end_test());
  if (layout_.test) {
    if (const auto before = names_.add(name, at.line))
      return fail(fmt::format("found the test {} again, expected its rows to stand together; it began on line {}",
                              text::quoted(name), *before),
                  at);
  }
  in_test_ = true;
  test_name_ = name;
  row_begin_ = test_name_ + preamble_.delimiter;
  test_line_ = at.line;
  return {};
}

Result<void> LongRows::add_cells(const std::vector<CsvCell>& cells) {
  const auto at = [&](std::size_t column) { return TextPosition{line_, cells[column].column}; };
  RowReading row{0.0, line_, 0, 0, 0};
  AXIOMETRY_TRY(const double target_number, numbers_.read(cells[layout_.target].text, at(layout_.target)));
  const Position target = position_in(*layout_.target_unit, target_number);
  AXIOMETRY_TRY(const Direction direction, direction_of(cells[layout_.direction]));
  row.direction = static_cast<std::uint8_t>(direction);
  row.target = targets_.number(target.in_native());
  AXIOMETRY_TRY(row.run, run_of(cells, row));
  const CsvCell& reading = cells[layout_.reading];
  if (is_missing(reading.text)) return {};
  AXIOMETRY_TRY(const double value, numbers_.read(reading.text, at(layout_.reading)));
  AXIOMETRY_TRY(row.deviation, placed(native_deviation(layout_.rule, target, value), at(layout_.reading)));
  if (readings_.size() >= reading_limit)
    return fail(fmt::format("found more than {} readings in one test, expected fewer", reading_limit), {line_, 1});
  if (doubts_thousands()) {
    thousands_.look_at(0, cells[layout_.target].text);
    thousands_.look_at(1, reading.text);
    ++rows_doubted_;
  }
  compare_with_position(cells, target, row.deviation);
  readings_.push_back(row);
  return {};
}

Result<Direction> LongRows::direction_of(const CsvCell& cell) {
  const auto direction = direction_from(cell.text);
  if (!direction)
    return fail(fmt::format("found {}, expected a direction: {}", text::quoted(cell.text), direction_words),
                {line_, cell.column});
  // A label of at most eight bytes fits one comparison; a longer one is read the general way each time.
  Label& label = labels_[static_cast<std::size_t>(*direction)];
  if (const std::size_t size = cell.text.size(); size <= 8) {
    char bytes[8] = {};
    std::memcpy(bytes, cell.text.data(), size);
    label = {detail::load_little_endian(bytes), size == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * size)) - 1,
             size};
  }
  return *direction;
}

std::size_t& LongRows::approaches_to(const RowReading& row) {
  const std::size_t slot = std::size_t{2} * row.target + row.direction;
  if (slot >= approaches_.size()) approaches_.resize(slot + 1);
  return approaches_[slot];
}

Result<std::uint16_t> LongRows::run_of(const std::vector<CsvCell>& cells, const RowReading& row) {
  if (layout_.run) {
    const CsvCell& cell = cells[*layout_.run];
    AXIOMETRY_TRY(const std::size_t number, run_number(cell.text, {line_, cell.column}));
    return static_cast<std::uint16_t>(number - 1);
  }
  std::size_t& approaches = approaches_to(row);
  if (approaches >= read_budget::runs)
    return fail(fmt::format("found more than {} approaches to one target, expected fewer", read_budget::runs),
                {line_, 1});
  return static_cast<std::uint16_t>(approaches++);
}

std::unexpected<Error> LongRows::second_reading(const RowReading& row) const {
  const auto first = std::ranges::find_if(readings_, [&](const RowReading& r) {
    return r.target == row.target && r.direction == row.direction && r.run == row.run;
  });
  return fail(fmt::format("found a second reading of target {}{} run {}, expected only that on line {}",
                          format_exact(targets_.targets()[row.target]), arrow(row.direction), row.run + 1, first->line),
              {row.line, 1});
}

Result<std::vector<double>> LongRows::dense(std::size_t runs) {
  const std::span<const std::uint32_t> ranks = targets_.ranks();
  const std::size_t m = ranks.size();
  std::vector<double> deviations(2 * m * runs, std::numeric_limits<double>::quiet_NaN());
  for (const RowReading& row : readings_) {
    double& cell = deviations[(row.direction * m + ranks[row.target]) * runs + row.run];
    if (!std::isnan(cell)) return second_reading(row);
    cell = row.deviation;
  }
  return deviations;
}

Result<void> LongRows::end_test() {
  const TextPosition at{test_line_, 0};
  if (const auto doubt = thousands_.found()) return fail(thousands_fault(*doubt), at);
  std::size_t runs = 0;
  for (const RowReading& row : readings_) runs = std::max<std::size_t>(runs, row.run + 1);
  const std::size_t m = targets_.targets().size();
  AXIOMETRY_TRY_VOID(placed(check_grid({.targets = m, .runs = runs, .readings = readings_.size()}), at));
  AXIOMETRY_TRY(std::vector<double> deviations, dense(runs));
  std::vector<Position> sorted(m);
  for (std::size_t k = 0; k < m; ++k) sorted[targets_.ranks()[k]] = Position::native(targets_.targets()[k]);
  AXIOMETRY_TRY(Series series, placed(Series::make_dense(std::move(sorted), runs, std::move(deviations)), at));
  if (layout_.rule.measured == Measured::deviation)
    AXIOMETRY_TRY_VOID(placed(check_deviations(series, layout_.kind), at));
  else
    AXIOMETRY_TRY_VOID(check_positions(at));
  AXIOMETRY_TRY_VOID(check_comparison(at));
  if (!layout_.test) remark_swapped_labels();
  if (!metadata_) {
    const char mark = numbers_.mark().value_or(preamble_.delimiter == ',' ? '.' : ',');
    AXIOMETRY_TRY(metadata_, metadata_of(preamble_, layout_.kind, mark));
  }
  rows_doubted_ = 0;
  readings_.clear();
  approaches_.clear();
  targets_.restart();
  in_test_ = false;
  return sink_({test_name_, test_line_, *metadata_, std::move(series), told_});
}

}  // namespace axiometry::formats
