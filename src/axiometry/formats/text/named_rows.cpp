// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/named_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/simulated_note.h"
#include "axiometry/formats/text/table_heads.h"

namespace axiometry::formats {

Result<NamedColumns> named_columns(std::string_view text, std::size_t line, const TableWords& words,
                                   std::span<const std::size_t> required) {
  NamedColumns columns;
  columns.at.resize(words.canonical.size());
  columns.unit.resize(words.canonical.size());
  columns.line = line;
  columns.delimiter = delimiter_of(text);
  AXIOMETRY_TRY(const std::vector<CsvCell> heads, split_row(text, columns.delimiter, line));
  columns.count = heads.size();
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const TableHead named = table_head(heads[k].text);
    const auto word = std::ranges::find(words.words, named.name, &ColumnWord::word);
    if (word == words.words.end()) {
      if (!heads[k].text.empty()) columns.passed_over.push_back(heads[k].text);
      continue;
    }
    if (columns.has(word->role))
      return fail(fmt::format("found {} a second time, expected one column of it", text::quoted(heads[k].text)),
                  {line, heads[k].column});
    columns.at[word->role] = k;
    columns.needed = k + 1;
    if (word->role >= words.angles) {
      AXIOMETRY_TRY(columns.unit[word->role], angle_unit(heads[k], named, words.canonical[word->role], line));
    } else if (word->role >= words.texts) {
      AXIOMETRY_TRY(columns.unit[word->role], length_unit(heads[k], named, words.canonical[word->role], line));
    }
  }
  std::vector<std::string_view> names;
  for (const std::size_t role : required) names.push_back(words.canonical[role]);
  for (const std::size_t role : required)
    if (!columns.has(role))
      return fail(
          fmt::format("found no column {}, expected a header with {}", words.canonical[role], fmt::join(names, ", ")),
          {line, 1});
  return columns;
}

Result<void> NamedRow::take(std::string_view line, std::size_t number, bool has_break) {
  line_ = line;
  number_ = number;
  if (line.find('"') != std::string_view::npos) return take_quoted(line, has_break);
  cells_.clear();
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(line.find(columns_.delimiter, begin), line.size());
    cells_.push_back({text::trim(line.substr(begin, end - begin)), begin + 1});
    if (end == line.size()) break;
    begin = end + 1;
    if (cells_.size() == read_budget::row_cells) return fail_row_cells({number, begin + 1});
  }
  return check(has_break);
}

TextPosition NamedRow::at(std::size_t role) const {
  const Cell& cell = cells_[*columns_.at[role]];
  const bool inside = cell.text.data() >= line_.data() && cell.text.data() <= line_.data() + line_.size();
  return {number_,
          inside && !cell.text.empty() ? static_cast<std::size_t>(cell.text.data() - line_.data()) + 1 : cell.column};
}

Result<void> NamedRow::take_quoted(std::string_view line, bool has_break) {
  AXIOMETRY_TRY(quoted_, split_row(line, columns_.delimiter, number_));
  cells_.clear();
  for (const CsvCell& cell : quoted_) cells_.push_back({cell.text, cell.column});
  return check(has_break);
}

Result<void> NamedRow::check(bool has_break) const {
  if (cells_.size() == columns_.count) return {};
  std::vector<CsvCell> cells;
  for (const Cell& cell : cells_) cells.push_back({std::string(cell.text), cell.column});
  return check_cell_count(cells,
                          {columns_.count, columns_.needed, columns_.line, number_, columns_.delimiter, !has_break});
}

std::size_t NameNumbers::number(std::string_view name) {
  for (const std::size_t guess : {last_, last_ + 1})
    if (guess < names_.size() && names_[guess] == name) return last_ = guess;
  const auto found = numbers_.find(name);
  if (found != numbers_.end()) return last_ = found->second;
  numbers_.emplace(name, names_.size());
  names_.emplace_back(name);
  return last_ = names_.size() - 1;
}

Result<std::string_view> NamedCells::name(const NamedRow& row, std::size_t role) const {
  const std::string_view name = row.cell(role);
  if (!name.empty()) return name;
  return fail(fmt::format("found no {}, expected its name or number", words_.canonical[role]), row.at(role));
}

Result<double> NamedCells::number(const NamedRow& row, std::size_t role) {
  const std::string_view cell = row.cell(role);
  if (!numbers_) numbers_.emplace(columns_.delimiter);  // the header has been read by now
  const auto plain = numbers_->mark() == '.' ? parse_number(cell) : std::nullopt;
  if (plain) return *plain;
  return numbers_->read(cell, row.at(role));
}

Result<double> NamedCells::length(const NamedRow& row, std::size_t role) {
  AXIOMETRY_TRY(const double value, number(row, role));
  return length_in_mm(*columns_.unit[role], value, row.cell(role), row.at(role));
}

Result<double> NamedCells::angle(const NamedRow& row, std::size_t role) {
  AXIOMETRY_TRY(const double value, number(row, role));
  const double degrees = position_in(*columns_.unit[role], value).in_native();
  if (std::abs(degrees) <= largest_stated) return degrees;
  return fail(fmt::format("found {}, expected an angle up to 1e9°", text::quoted(row.cell(role))), row.at(role));
}

Result<Vector3> NamedCells::place(const NamedRow& row, std::size_t first_role) {
  Vector3 at;
  AXIOMETRY_TRY(at.x, length(row, first_role));
  AXIOMETRY_TRY(at.y, length(row, first_role + 1));
  AXIOMETRY_TRY(at.z, length(row, first_role + 2));
  return at;
}

Result<void> for_named_rows(std::string_view text, NamedColumns& columns, const TableWords& words,
                            std::span<const std::size_t> required, std::string_view example,
                            const std::function<Result<void>(const NamedRow&)>& take) {
  NamedRow row(columns);
  bool simulated = false;
  AXIOMETRY_TRY_VOID(for_table_lines(text, [&](const TableLine& line) -> Result<void> {
    if (line.content.starts_with('#')) {
      simulated = simulated || is_simulated_note(line.content);
      return {};
    }
    if (columns.count == 0) {
      AXIOMETRY_TRY(columns, named_columns(line.text, line.number, words, required));
      return {};
    }
    AXIOMETRY_TRY_VOID(row.take(line.text, line.number, line.has_break));
    return take(row);
  }));
  columns.simulated = simulated;
  if (columns.count != 0) return {};
  return fail(fmt::format("found no header, expected one as {}", example));
}

}  // namespace axiometry::formats
