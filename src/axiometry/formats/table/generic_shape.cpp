// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/table/generic_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "axiometry/base/counted.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/head_words.h"
#include "axiometry/formats/text/thousands.h"

namespace axiometry::formats::generic {
namespace {

constexpr std::size_t lines_weighed = 2000;  // lines that are weighed to choose a delimiter
constexpr std::string_view comment_marks[] = {"#", "%", "//"};

bool is_number(std::string_view cell) { return number_in(cell, '.') || number_in(cell, ',') || is_bad_number(cell); }

struct Census {
  std::size_t numbers = 0;
  std::size_t missing = 0;
  std::size_t words = 0;
};

Census census_of(const std::vector<CsvCell>& cells) {
  Census census;
  for (const CsvCell& cell : cells) {
    if (is_number(cell.text))
      ++census.numbers;
    else
      ++(is_missing(cell.text) ? census.missing : census.words);
  }
  return census;
}

bool is_blank(const PlainLine& line) { return text::trim(line.text).empty(); }

/// Lines taken apart at one delimiter.
struct Split {
  Delimiter delimiter = Delimiter::comma;
  std::size_t columns = 0;
  double score = 0.0;  ///< rows times the share of their cells that are numbers or missing
  std::size_t rows = 0;
};

Split split_at(std::span<const PlainLine> lines, Delimiter delimiter, std::string_view comment) {
  struct Count {
    std::size_t rows = 0;
    std::size_t cells = 0;
    std::size_t numeric = 0;
  };
  std::map<std::size_t, Count> by_width;
  std::size_t weighed = 0;
  for (const PlainLine& line : lines) {
    if (is_blank(line) || is_comment(line.text, comment)) continue;
    if (++weighed > lines_weighed) break;
    const auto cells = cells_of(line, {delimiter, false});
    if (!cells || cells->size() < 2) continue;
    const Census census = census_of(*cells);
    if (census.numbers < 2) continue;
    Count& count = by_width[cells->size()];
    ++count.rows;
    count.cells += cells->size();
    count.numeric += census.numbers + census.missing;
  }
  Split best{delimiter};
  for (const auto& [width, count] : by_width) {
    const double score =
        static_cast<double>(count.rows) * static_cast<double>(count.numeric) / static_cast<double>(count.cells);
    if (score > best.score) best = {delimiter, width, score, count.rows};
  }
  return best;
}

Split best_split(std::span<const PlainLine> lines, std::string_view comment) {
  Split best;
  for (const Delimiter delimiter : {Delimiter::tab, Delimiter::semicolon, Delimiter::comma, Delimiter::blanks}) {
    const Split trial = split_at(lines, delimiter, comment);
    if (trial.score > best.score) best = trial;
  }
  return best;
}

std::string comment_mark_of(std::span<const PlainLine> lines) {
  for (const PlainLine& line : lines)
    for (std::string_view mark : comment_marks)
      if (text::trim(line.text).starts_with(mark)) return std::string(mark);
  return "#";
}

/// A line of a table of this width: the right number of cells, numbers among them, and no more words than usual.
struct Block {
  std::size_t first = 0;  // indices of lines
  std::size_t last = 0;
};

std::optional<Block> block_of(std::span<const PlainLine> lines, const Split& split, std::string_view comment) {
  std::optional<Block> block;
  std::size_t words_at_most = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (is_blank(lines[k]) || is_comment(lines[k].text, comment)) continue;
    const auto cells = cells_of(lines[k], {split.delimiter, false});
    if (!cells || cells->size() != split.columns) continue;
    const Census census = census_of(*cells);
    if (!block && census.numbers >= 2) block = Block{k, k};
    if (!block) continue;
    if (census.numbers >= 2) words_at_most = std::max(words_at_most, census.words);
    // A row whose readings are all missing still belongs to the table, "Mittel;;;2,2" does not.
    const bool of_table = census.words <= words_at_most && head_of(cells->front().text).role != HeadRole::ignored;
    if (census.numbers >= 2 || (census.numbers == 1 && of_table)) block->last = k;
  }
  return block;
}

std::unexpected<Error> another_length(std::size_t found, std::size_t expected, TextPosition at) {
  return fail(fmt::format("found {}, expected {} as in the rest of the table", counted(found, "field"), expected), at);
}

/// Rows of numbers below the table would be lost with what stands there.
Result<void> check_below(std::span<const PlainLine> below, const Split& split, std::string_view comment) {
  for (const PlainLine& line : below) {
    if (is_blank(line) || is_comment(line.text, comment)) continue;
    AXIOMETRY_TRY(const std::vector<CsvCell> cells, cells_of(line, {split.delimiter, false}));
    const Census census = census_of(cells);
    if (census.numbers >= 2 && census.numbers > census.words)
      return another_length(cells.size(), split.columns, {line.number, 1});
  }
  return {};
}

void take_units(TableShape& shape, const std::vector<std::string>& cells) {
  for (const std::string& cell : cells) shape.units.push_back(unit_in(cell));
}

bool holds_units_only(const std::vector<std::string>& cells) {
  std::size_t found = 0;
  for (const std::string& cell : cells) {
    if (unit_in(cell) != nullptr)
      ++found;
    else if (!is_missing(cell) && cell != "[]" && cell != "()" && cell != "[-]" && cell != "[s]" && cell != "s")
      return false;
  }
  return found > 0;
}

/// The header directly above the rows: names, or names and a line of units.
void find_names(TableShape& shape, std::span<const PlainLine> above) {
  std::size_t end = above.size();
  std::optional<std::size_t> units_at;
  while (end > 0) {
    const PlainLine& line = above[--end];
    if (is_blank(line)) continue;
    std::string_view content = text::trim(line.text);
    if (is_comment(content, shape.comment)) content = text::trim(content.substr(shape.comment.size()));
    std::vector<std::string> names = names_in(content, shape.rule.delimiter, shape.columns);
    if (names.size() + 1 == shape.columns && shape.rule.delimiter != Delimiter::blanks) names.emplace_back();
    if (names.size() != shape.columns) break;
    if (!units_at && holds_units_only(names)) {
      take_units(shape, names);
      units_at = end;
      continue;
    }
    const auto numbers =
        std::ranges::count_if(names, [](const std::string& n) { return n.contains(':') || is_bad_number(n); });
    if (numbers > 0) break;
    shape.names = std::move(names);
    shape.header_lines = units_at ? 2 : 1;
    shape.above = above.first(end);
    return;
  }
  shape.above = above;
  if (!units_at) return;
  shape.above = above.first(*units_at);  // units without names: no header, the rows follow after skipped lines
}

/// "1,5" among "2.5", and "1,250" that could be a thousand.
void find_decimal_mark(TableShape& shape) {
  bool comma = false;
  bool point = false;
  bool only_thousands = true;
  ThousandsDoubt thousands(shape.columns);
  for (const auto& row : shape.rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string& cell = row[c];
      if (number_in(cell, ',') || number_in(cell, '.')) thousands.look_at(c, cell);
      const std::size_t at = cell.find(',');
      if (at != std::string::npos && number_in(cell, ',')) {
        comma = true;
        const std::size_t digits = cell.find_first_of("0123456789");
        only_thousands = only_thousands && cell.size() - at == 4 && at - digits <= 3 && cell[digits] != '0';
      }
      point = point || (cell.contains('.') && number_in(cell, '.'));
    }
  shape.mark_seen = comma || point;
  shape.decimal_mark = comma ? ',' : '.';
  if (comma && point)
    shape.questions.push_back({"decimal_mark", "", 0.0,
                               "found numbers with a comma and numbers with a point; which is the decimal mark, point "
                               "or comma?"});
  else if (comma && only_thousands)
    shape.questions.push_back(
        {"decimal_mark", "", 0.0,
         "found commas only before three digits, as in \"1,250\"; they may be decimal marks or part "
         "thousands: remove those, or say comma"});
  else if (const auto doubt = comma || shape.rule.delimiter == Delimiter::comma ? std::nullopt : thousands.found())
    shape.questions.push_back(
        {"decimal_mark", "", 0.0,
         fmt::format("found {} and {} in one column; points may be decimal marks or part thousands: remove those, or "
                     "say point",
                     text::quoted(doubt->marked), text::quoted(doubt->whole))});
}

/// Decimal commas between commas: twice as many whole numbers as there are columns.
void find_pairs(TableShape& shape, std::span<const PlainLine> above) {
  if (shape.rule.delimiter != Delimiter::comma || shape.mark_seen) return;
  const auto looks_like_decimals = [](const std::string& cell) {
    return cell.size() >= 2 && cell.front() == '0' && cell.find_first_not_of("0123456789") == std::string::npos;
  };
  bool leading_zeros = false;
  for (const auto& row : shape.rows) leading_zeros = leading_zeros || std::ranges::any_of(row, looks_like_decimals);
  if (!shape.names.empty() && !leading_zeros) return;
  // How many columns the rows have when neighbours are paired, and whether a header agrees.
  std::optional<std::size_t> paired;
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : shape.rows) {
    std::string line;
    for (const std::string& cell : row) line += (line.empty() ? "" : ",") + cell;
    const auto cells = cells_of({line, 0}, {Delimiter::comma, true});
    if (!cells || (paired && *paired != cells->size())) return;
    paired = cells->size();
    auto& kept = rows.emplace_back();
    for (const CsvCell& cell : *cells) kept.push_back(cell.text);
  }
  const bool whole =
      paired && std::ranges::all_of(rows, [](const auto& row) {
        return std::ranges::all_of(row, [](const std::string& c) { return c.contains(',') || !is_number(c); });
      });
  TableShape trial = shape;
  trial.columns = paired.value_or(0);
  trial.names.clear();
  if (whole) find_names(trial, above);
  if (whole && !trial.names.empty()) {
    trial.rows = std::move(rows);
    trial.rule.paired = true;
    trial.decimal_mark = ',';
    trial.mark_seen = true;
    shape = std::move(trial);
    return;
  }
  if (leading_zeros)
    shape.questions.push_back(
        {"delimiter", "", 0.0,
         "found whole numbers between commas, some with leading zeros; commas may be decimal marks "
         "as well as delimiters: save the file with semicolons or tabs between the columns"});
}

/// The cells of the block. Fails on rows of another length; spreadsheets cut off empty cells, but no numbers.
Result<void> take_rows(TableShape& shape, std::span<const PlainLine> block) {
  std::size_t widest_needed = 0;  // columns up to the last one with a number
  std::vector<std::pair<PlainLine, std::size_t>> short_rows;
  for (const PlainLine& line : block) {
    if (is_blank(line) || is_comment(line.text, shape.comment)) continue;
    ++shape.row_count;
    if (shape.rows.size() >= rows_looked_at) continue;
    AXIOMETRY_TRY(const std::vector<CsvCell> cells, cells_of(line, shape.rule));
    std::size_t count = cells.size();
    while (count > shape.columns && cells[count - 1].text.empty()) --count;
    if (count > shape.columns) return another_length(count, shape.columns, {line.number, cells[shape.columns].column});
    if (count < shape.columns) short_rows.emplace_back(line, count);
    auto& row = shape.rows.emplace_back(shape.columns);
    shape.row_lines.push_back(line);
    for (std::size_t c = 0; c < count; ++c) {
      row[c] = cells[c].text;
      if (is_number(row[c])) widest_needed = std::max(widest_needed, c + 1);
    }
  }
  for (const auto& [line, count] : short_rows)
    if (count < widest_needed) return another_length(count, shape.columns, {line.number, 1});
  return {};
}

/// What a line below the rows begins with and no row does: its first cell, or all of it.
std::string end_of_table(const PlainLine& line, const TableShape& shape) {
  const auto cells = cells_of(line, shape.rule);
  std::string first = cells && !cells->empty() ? cells->front().text : std::string();
  const bool taken = std::ranges::any_of(shape.rows, [&](const auto& row) { return row.front().starts_with(first); });
  return first.empty() || taken ? std::string(text::trim(line.text)) : first;
}

}  // namespace

std::size_t rows_of_table(std::span<const PlainLine> lines) { return best_split(lines, comment_mark_of(lines)).rows; }

Result<TableShape> find_shape(std::span<const PlainLine> lines) {
  TableShape shape;
  shape.comment = comment_mark_of(lines);
  const Split split = best_split(lines, shape.comment);
  const auto block = split.score > 0.0 ? block_of(lines, split, shape.comment) : std::nullopt;
  if (!block) {
    for (const PlainLine& line : lines)
      for (const char delimiter : {';', '\t', ',', ' '})
        if (const auto count = std::ranges::count(line.text, delimiter);
            count >= static_cast<std::ptrdiff_t>(read_budget::guessed_columns))
          return fail(fmt::format("found {} columns, expected at most {}", count + 1, read_budget::guessed_columns),
                      {line.number, 1});
    return fail("found no table of numbers, expected at least two columns of them");
  }
  AXIOMETRY_TRY_VOID(check_below(lines.subspan(block->last + 1), split, shape.comment));
  shape.rule = {split.delimiter, false};
  shape.columns = split.columns;
  shape.first_line = lines[block->first].number;
  AXIOMETRY_TRY_VOID(take_rows(shape, lines.subspan(block->first, block->last - block->first + 1)));
  for (const PlainLine& line : lines.subspan(block->last + 1)) {
    if (is_blank(line) || is_comment(line.text, shape.comment)) continue;
    shape.end = end_of_table(line, shape);
    break;
  }
  find_decimal_mark(shape);
  const std::span<const PlainLine> above = lines.first(block->first);
  find_names(shape, above);
  find_pairs(shape, above);
  return shape;
}

}  // namespace axiometry::formats::generic
