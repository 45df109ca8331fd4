// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/table/generic_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/moment.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats::generic {
namespace {

constexpr std::string_view true_minus = "\u2212";

/// Names of the encodings in decoded_text(), in the order of TextEncoding from utf8 on.
constexpr std::string_view encoding_titles[] = {"UTF-8", "UTF-16", "GBK", "Windows-1252", "Latin-1"};

std::vector<CsvCell> blank_cells(std::string_view line) {
  std::vector<CsvCell> cells;
  for (std::string_view word : text::words(line))
    cells.push_back({std::string(word), static_cast<std::size_t>(word.data() - line.data()) + 1});
  return cells;
}

bool is_whole(std::string_view cell, bool signed_one) {
  if (signed_one && (cell.starts_with('-') || cell.starts_with('+'))) cell.remove_prefix(1);
  return !cell.empty() && std::ranges::all_of(cell, [](char c) { return c >= '0' && c <= '9'; });
}

/// "0", "5" → "0,5": the comma between them was a decimal mark. Cells that were quoted have their own.
std::vector<CsvCell> paired_cells(std::vector<CsvCell> cells) {
  std::vector<CsvCell> pairs;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    CsvCell cell = std::move(cells[k]);
    if (k + 1 < cells.size() && is_whole(cell.text, true) && is_whole(cells[k + 1].text, false))
      cell.text += "," + cells[++k].text;
    pairs.push_back(std::move(cell));
  }
  return pairs;
}

char byte_of(Delimiter delimiter) {
  switch (delimiter) {
    case Delimiter::semicolon: return ';';
    case Delimiter::tab: return '\t';
    case Delimiter::comma:
    case Delimiter::blanks: break;
  }
  return ',';
}

}  // namespace

Result<DecodedText> decode(std::string_view bytes, TextEncoding encoding) {
  if (bytes.size() > read_budget::file_bytes)
    return fail(fmt::format("found {} bytes, expected at most {} for a table of an unknown layout", bytes.size(),
                            read_budget::file_bytes));
  if (encoding == TextEncoding::automatic) return decoded_text(bytes);
  return decoded_as(bytes, encoding_titles[static_cast<std::size_t>(encoding) - 1]);
}

std::vector<PlainLine> lines_of(std::string_view text) {
  std::vector<PlainLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
    lines.push_back({line, number});
    const bool crlf = text.substr(end).starts_with("\r\n");
    text.remove_prefix(std::min(end + (crlf ? 2 : 1), text.size()));
  }
  return lines;
}

RowRule row_rule(const ImportProfile& profile) {
  return {profile.delimiter, profile.delimiter == Delimiter::comma && profile.decimal_mark == ','};
}

Result<std::vector<CsvCell>> cells_of(const PlainLine& line, RowRule rule) {
  const auto too_many = [&](std::size_t count) {
    return fail(fmt::format("found {} columns, expected at most {}", count, read_budget::guessed_columns),
                {line.number, 1});
  };
  if (rule.delimiter == Delimiter::blanks) {
    std::vector<CsvCell> cells = blank_cells(line.text);
    if (cells.size() > read_budget::guessed_columns) return too_many(cells.size());
    return cells;
  }
  const char delimiter = byte_of(rule.delimiter);
  if (const auto count = static_cast<std::size_t>(std::ranges::count(line.text, delimiter));
      count >= 2 * read_budget::guessed_columns)
    return too_many(count + 1);
  AXIOMETRY_TRY(std::vector<CsvCell> cells, split_row(line.text, delimiter, line.number));
  if (rule.paired) cells = paired_cells(std::move(cells));
  if (cells.size() > read_budget::guessed_columns) return too_many(cells.size());
  return cells;
}

std::optional<double> number_in(std::string_view cell, char decimal_mark) {
  std::string plain(cell);
  if (plain.starts_with(true_minus)) plain.replace(0, true_minus.size(), "-");
  const char other = decimal_mark == ',' ? '.' : ',';
  if (plain.empty() || plain.back() == '.' || plain.back() == ',' || plain.find(other) != std::string::npos) return {};
  std::ranges::replace(plain, ',', '.');
  return parse_number(plain);
}

Result<double> number_at(const CsvCell& cell, char decimal_mark, std::size_t line) {
  if (const auto number = number_in(cell.text, decimal_mark)) return *number;
  const bool other_mark = number_in(cell.text, decimal_mark == ',' ? '.' : ',').has_value();
  const bool both = cell.text.find(',') != std::string::npos && cell.text.find('.') != std::string::npos;
  return fail(fmt::format("found {}, expected a finite number{}{}", text::quoted(cell.text),
                          other_mark ? fmt::format(" with a decimal {}", decimal_mark == ',' ? "comma" : "point") : "",
                          both ? " with one decimal mark; marks between thousands must be removed" : ""),
              {line, cell.column});
}

bool is_bad_number(std::string_view cell) {
  const std::string lower = text::to_lower(cell);
  std::string_view word = lower;
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  if (word.starts_with("nan") || word.starts_with("inf") || word.starts_with("1.#") || word.starts_with("#num") ||
      word.starts_with("#div"))
    return true;
  constexpr std::string_view characters = "0123456789.,eE+-";
  const auto digits = std::ranges::count_if(word, [](char c) { return c >= '0' && c <= '9'; });
  return digits > 0 && word.find_first_not_of(characters) == std::string_view::npos && !number_in(cell, '.') &&
         !number_in(cell, ',');
}

std::optional<double> clock_seconds(std::string_view cell, char decimal_mark) {
  if (const auto seconds = number_in(cell, decimal_mark)) return seconds;
  std::string plain(cell);
  std::ranges::replace(plain, ',', '.');
  if (const auto stamp = time_stamp_s(plain)) return stamp;
  const auto parts = text::split(plain, ':');
  if (parts.size() != 3) return std::nullopt;
  const auto hours = parse_count(parts[0]);
  const auto minutes = parse_count(parts[1]);
  if (parts[2].starts_with('-')) return std::nullopt;
  const auto rest = number_in(parts[2], '.');
  if (!hours || !minutes || !rest || *hours > 23 || *minutes > 59 || *rest >= 61.0) return std::nullopt;
  return static_cast<double>(*hours * 3600 + *minutes * 60) + *rest;
}

bool is_newest_first(std::span<const double> times_s) {
  constexpr double day_s = 86400.0;
  if (times_s.size() < 2 || !(times_s.front() > times_s.back())) return false;
  const double most = times_s.front() < day_s ? 0.5 * day_s : std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < times_s.size(); ++k) {
    const double fall = times_s[k - 1] - times_s[k];
    if (!(fall >= 0.0 && fall < most)) return false;
  }
  return true;
}

}  // namespace axiometry::formats::generic
