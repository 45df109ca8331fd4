// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/generic_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/text_source.h"

namespace axiometry::formats::generic {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view true_minus = "\u2212";

/// Windows-1252 from 0x80 to 0x9F; elsewhere it is Latin-1. 0: not assigned.
constexpr std::array<char16_t, 32> windows_1252 = {0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                   0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                                   0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                   0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void append_utf8(std::string& text, char32_t code) {
  const auto byte = [&](char32_t value) { text += static_cast<char>(value); };
  if (code < 0x80) return byte(code);
  if (code < 0x800) {
    byte(0xC0 | (code >> 6));
  } else {
    if (code < 0x10000) {
      byte(0xE0 | (code >> 12));
    } else {
      byte(0xF0 | (code >> 18));
      byte(0x80 | ((code >> 12) & 0x3F));
    }
    byte(0x80 | ((code >> 6) & 0x3F));
  }
  byte(0x80 | (code & 0x3F));
}

Result<std::string> from_latin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto code = static_cast<unsigned char>(c);
    const char32_t character = code >= 0x80 && code < 0xA0 ? windows_1252[code - 0x80] : code;
    if (character == 0 && code != 0)
      return fail(fmt::format("found the byte 0x{:02X}, expected text in UTF-8, UTF-16 or Latin-1", code));
    append_utf8(text, character);
  }
  return text;
}

Result<std::string> from_utf16(std::string_view bytes) {
  const bool big = bytes.starts_with("\xFE\xFF"sv);
  if (!big && !bytes.starts_with("\xFF\xFE"sv))
    return fail("found no byte order mark, expected UTF-16 to begin with one", {1, 1});
  bytes.remove_prefix(2);
  if (bytes.size() % 2 != 0) return fail("found an odd number of bytes, expected UTF-16; is the file cut off?");
  const auto unit = [&](std::size_t k) {
    const auto a = static_cast<unsigned char>(bytes[k]);
    const auto b = static_cast<unsigned char>(bytes[k + 1]);
    return static_cast<char32_t>(big ? a << 8 | b : b << 8 | a);
  };
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 2) {
    char32_t code = unit(k);
    if (code >= 0xD800 && code < 0xE000) {
      const char32_t low = k + 2 < bytes.size() ? unit(k + 2) : 0;
      if (code >= 0xDC00 || low < 0xDC00 || low >= 0xE000) return fail("found half a surrogate pair, expected UTF-16");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
      k += 2;
    }
    append_utf8(text, code);
  }
  return text;
}

bool is_utf16(std::string_view bytes) { return bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv); }

Result<void> check_text(std::string_view text) {
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
    return fail("found a NUL byte, so this is a binary file, expected a text file");
  if (text::trim(text).empty()) return fail("found an empty file, expected measured deviations");
  return {};
}

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
  if (bytes.size() > byte_limit)
    return fail(
        fmt::format("found {} bytes, expected at most {} for a table of an unknown layout", bytes.size(), byte_limit));
  DecodedText text;
  if (encoding == TextEncoding::utf16 || (encoding == TextEncoding::automatic && is_utf16(bytes))) {
    AXIOMETRY_TRY(text.utf8, from_utf16(bytes));
    text.encoding = TextEncoding::utf16;
  } else if (encoding == TextEncoding::latin1 || (encoding == TextEncoding::automatic && text::invalid_utf8(bytes))) {
    AXIOMETRY_TRY_VOID(check_text(bytes));
    AXIOMETRY_TRY(text.utf8, from_latin1(bytes));
    text.encoding = TextEncoding::latin1;
  } else {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    AXIOMETRY_TRY_VOID(check_utf8(bytes));
    text.utf8 = std::string(bytes);
  }
  AXIOMETRY_TRY_VOID(check_text(text.utf8));
  return text;
}

std::vector<TextLine> lines_of(std::string_view text) {
  std::vector<TextLine> lines;
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

Result<std::vector<CsvCell>> cells_of(const TextLine& line, RowRule rule) {
  const auto too_many = [&](std::size_t count) {
    return fail(fmt::format("found {} columns, expected at most {}", count, column_limit), {line.number, 1});
  };
  if (rule.delimiter == Delimiter::blanks) {
    std::vector<CsvCell> cells = blank_cells(line.text);
    if (cells.size() > column_limit) return too_many(cells.size());
    return cells;
  }
  const char delimiter = byte_of(rule.delimiter);
  if (const auto count = static_cast<std::size_t>(std::ranges::count(line.text, delimiter)); count >= 2 * column_limit)
    return too_many(count + 1);
  AXIOMETRY_TRY(std::vector<CsvCell> cells, split_row(line.text, delimiter, line.number));
  if (rule.paired) cells = paired_cells(std::move(cells));
  if (cells.size() > column_limit) return too_many(cells.size());
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
  double days = 0.0;
  if (cell.size() > 10 && cell[4] == '-' && cell[7] == '-' && (cell[10] == ' ' || cell[10] == 'T')) {
    const auto year = parse_count(cell.substr(0, 4));
    const auto month = parse_count(cell.substr(5, 2));
    const auto day = parse_count(cell.substr(8, 2));
    if (!year || !month || !day) return std::nullopt;
    const std::chrono::year_month_day date(std::chrono::year(static_cast<int>(*year)),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day)));
    if (!date.ok()) return std::nullopt;
    days = static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
    cell = text::trim(cell.substr(11));
    if (cell.ends_with('Z')) cell.remove_suffix(1);
  }
  const auto parts = text::split(cell, ':');
  if (parts.size() != 3) return std::nullopt;
  const auto hours = parse_count(parts[0]);
  const auto minutes = parse_count(parts[1]);
  const auto seconds = parts[2].empty() || parts[2].starts_with('-')
                           ? std::nullopt
                           : number_in(parts[2], parts[2].contains(',') ? ',' : '.');
  if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds >= 61.0) return std::nullopt;
  constexpr double seconds_per_day = 86400.0;
  return days * seconds_per_day + static_cast<double>(*hours * 3600 + *minutes * 60) + *seconds;
}

}  // namespace axiometry::formats::generic
