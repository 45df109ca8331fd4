// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/csv_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/counted.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/series/series_order.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace {

constexpr std::string_view true_minus = "\u2212";
constexpr std::string_view up_words[] = {"up",  "↑",   "+",        "+1",        "1",   "forward", "forwards",
                                         "fwd", "fw",  "f",        "positive",  "pos", "u",       "increasing",
                                         "hin", "vor", "vorwärts", "vorwaerts", "auf", "positiv"};
constexpr std::string_view down_words[] = {
    "down",   "↓",       "-",       true_minus, "-1",        "backward",    "backwards", "bwd",    "bw",
    "b",      "back",    "reverse", "rev",      "r",         "negative",    "neg",       "d",      "decreasing",
    "zurück", "zurueck", "rück",    "rueck",    "rückwärts", "rueckwaerts", "ab",        "negativ"};
constexpr std::string_view missing_words[] = {"",   "-",   "--",   "–",    "—",    true_minus,
                                              "na", "n/a", "#n/a", "null", "none", "missing"};

Result<CsvCell> quoted_cell(std::string_view line, std::size_t& k, char delimiter, TextPosition at) {
  CsvCell cell{{}, at.column};
  while (true) {
    const std::size_t quote = line.find('"', ++k);
    if (quote == std::string_view::npos)
      return fail("found a quoted field that does not end on its line, expected a closing quote", at);
    cell.text += line.substr(k, quote - k);
    k = quote + 1;
    if (k >= line.size() || line[k] != '"') break;
    cell.text += '"';
  }
  const std::size_t end = std::min(line.find(delimiter, k), line.size());
  if (const std::string_view after = text::trim(line.substr(k, end - k)); !after.empty())
    return fail(fmt::format("found {} after a closing quote, expected the end of the field", text::quoted(after)),
                {at.line, k + 1});
  k = end;
  return cell;
}

constexpr std::string_view summary_words[] = {"mean",       "average",
                                              "avg",        "std",
                                              "stdev",      "stddev",
                                              "sigma",      "s",
                                              "min",        "max",
                                              "range",      "median",
                                              "sum",        "total",
                                              "totals",     "mittel",
                                              "mittelwert", "summe",
                                              "gesamt",     "minimum",
                                              "maximum",    "standardabweichung",
                                              "streuung"};

/// What to change in a cell that holds no plain number, where that is known.
std::string_view advice_on(std::string_view cell) {
  if (text::is_one_of(cell, summary_words)) return "; rows of means and totals must be removed";
  const std::size_t end = cell.find_last_of("0123456789");
  if (end == std::string_view::npos) return "";
  if (find_unit(text::trim(cell.substr(end + 1))) != nullptr) return "; units belong in the header alone";
  const bool grouped = std::ranges::all_of(cell, [](char c) {
    return (c >= '0' && c <= '9') || std::string_view("+-., '\xC2\xA0\xE2\x80\xAF").find(c) != std::string_view::npos;
  });
  return grouped ? "; marks between thousands must be removed" : "";
}

}  // namespace

std::unexpected<Error> fail_row_cells(TextPosition at) {
  return fail(fmt::format("found more than {} fields in one row, expected fewer", read_budget::row_cells), at);
}

Result<std::vector<CsvCell>> split_row(std::string_view line, char delimiter, std::size_t line_number) {
  std::vector<CsvCell> cells;
  for (std::size_t k = 0;; ++k) {
    const std::size_t begin = std::min(line.find_first_not_of(' ', k), line.size());
    if (begin < line.size() && line[begin] == '"') {
      k = begin;
      AXIOMETRY_TRY(CsvCell cell, quoted_cell(line, k, delimiter, {line_number, begin + 1}));
      cells.push_back(std::move(cell));
    } else {
      const std::size_t end = std::min(line.find(delimiter, k), line.size());
      const std::string_view text = text::trim(line.substr(k, end - k));
      cells.push_back(
          {std::string(text), (text.empty() ? k : static_cast<std::size_t>(text.data() - line.data())) + 1});
      k = end;
    }
    if (k >= line.size()) return cells;
    if (cells.size() == read_budget::row_cells) return fail_row_cells({line_number, k + 2});
  }
}

Result<void> check_cell_count(const std::vector<CsvCell>& cells, const RowShape& shape) {
  std::size_t found = cells.size();
  while (found > shape.expected && cells[found - 1].text.empty()) --found;
  if (found <= shape.expected && found >= shape.needed) return {};
  std::string_view hint;
  if (found < shape.expected && shape.cut_off) hint = "; the file ends here, is it cut off?";
  if (found > shape.expected && shape.delimiter == ',')
    hint = "; numbers with a decimal comma need semicolons or tabs between the columns";
  const std::size_t place = found > shape.expected ? cells[shape.expected].column : cells.back().column;
  return fail(fmt::format("found {}, expected {} as in the header on line {}{}", counted(found, "field"),
                          shape.expected, shape.header_line, hint),
              {shape.line, place});
}

Result<std::size_t> run_number(std::string_view cell, TextPosition at) {
  const auto number = parse_number(cell);
  if (number && *number >= 1 && *number <= static_cast<double>(read_budget::runs) && std::floor(*number) == *number)
    return static_cast<std::size_t>(*number);
  const std::string_view advice =
      number && *number == 0 ? "; runs count from 1, so add 1 to every run, or read the file as the format generic"
                             : "";
  return fail(fmt::format("found the run {}, expected a whole number from 1 to {}{}", text::quoted(cell),
                          read_budget::runs, advice),
              at);
}

char delimiter_of(std::string_view header_line) {
  char best = ',';
  std::ptrdiff_t most = 0;
  for (const char candidate : {';', '\t', ','}) {
    bool quoted = false;
    const auto count = std::ranges::count_if(header_line, [&](char c) {
      if (c == '"') quoted = !quoted;
      return c == candidate && !quoted;
    });
    if (count <= most) continue;
    most = count;
    best = candidate;
  }
  return best;
}

std::optional<Direction> direction_from(std::string_view word) {
  if (text::is_one_of(word, up_words)) return Direction::up;
  if (text::is_one_of(word, down_words)) return Direction::down;
  return std::nullopt;
}

bool is_missing(std::string_view cell) { return text::is_one_of(cell, missing_words); }

Result<void> NumberReader::settle_mark(char mark, std::string_view cell, TextPosition at) {
  if (mark == ',' && delimiter_ == ',')
    return fail(fmt::format("found {} in a file separated by commas, expected a number with a decimal point",
                            text::quoted(cell)),
                at);
  if (!mark_) {
    mark_ = mark;
    mark_at_ = at;
  }
  if (*mark_ == mark) return {};
  return fail(fmt::format("found {} with a decimal {}, expected a decimal {} as on line {}", text::quoted(cell),
                          mark == ',' ? "comma" : "point", mark == ',' ? "point" : "comma", mark_at_.line),
              at);
}

Result<double> NumberReader::read(std::string_view cell, TextPosition at) {
  std::string plain(cell);
  if (plain.starts_with(true_minus)) plain.replace(0, true_minus.size(), "-");
  const bool comma = plain.find(',') != std::string::npos;
  const bool point = plain.find('.') != std::string::npos;
  if (comma && point)
    return fail(fmt::format("found {} with a comma and a point, expected a number with one decimal mark{}",
                            text::quoted(cell), advice_on(cell)),
                at);
  std::ranges::replace(plain, ',', '.');
  const auto value = parse_number(plain);
  if (!value) return fail(fmt::format("found {}, expected a finite number{}", text::quoted(cell), advice_on(cell)), at);
  if (comma || point) AXIOMETRY_TRY_VOID(settle_mark(comma ? ',' : '.', cell, at));
  return *value;
}

}  // namespace axiometry::formats
