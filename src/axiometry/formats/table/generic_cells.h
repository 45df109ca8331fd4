// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/formats/table/import_profile.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"

/// Text of unknown make as lines, cells and numbers. Private to the generic importer (generic_delimited.h).
namespace axiometry::formats::generic {

/// Any text as UTF-8, its encoding found out or stated. Fails as decoded_text() does, and on more than
/// read_budget::file_bytes.
Result<DecodedText> decode(std::string_view bytes, TextEncoding encoding);

struct PlainLine {
  std::string_view text;   ///< line without its break and blanks at its end
  std::size_t number = 0;  ///< number of the line, from 1
};

/// Lines end in LF, CRLF or CR.
std::vector<PlainLine> lines_of(std::string_view text);

/// How rows are taken apart.
struct RowRule {
  Delimiter delimiter = Delimiter::comma;
  bool paired = false;  ///< numbers have decimal commas between commas: two whole numbers side by side are one
};

RowRule row_rule(const ImportProfile& profile);

/// The cells of a line. Fails on open quotes and on more than column_limit cells.
Result<std::vector<CsvCell>> cells_of(const PlainLine& line, RowRule rule);

/// The number in a cell, with this decimal mark; nothing when it is none. "5." is no number between blanks' commas:
/// a mark needs a digit behind it.
std::optional<double> number_in(std::string_view cell, char decimal_mark);

/// The same; fails with the reason.
Result<double> number_at(const CsvCell& cell, char decimal_mark, std::size_t line);

/// Whether the cell was meant as a number but is none: "NaN", "inf", "-1.#IND", "1.2.3".
bool is_bad_number(std::string_view cell);

/// Seconds: a number of them, a time stamp as time_stamp_s() reads it (also with a decimal comma), or "12:30:05.25".
std::optional<double> clock_seconds(std::string_view cell, char decimal_mark);

/// Whether the times of all rows are known and only fall, as where the newest is listed first. Among times of a day a
/// fall of half a day or more from one row to the next is midnight; with their date a test may rest as long.
bool is_newest_first(std::span<const double> times_s);

}  // namespace axiometry::formats::generic
