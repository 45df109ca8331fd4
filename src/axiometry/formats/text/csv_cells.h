// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/series.h"

/// Rows and cells of delimited text: RFC 4180 quotes, any one-byte delimiter, decimal point or comma.
namespace axiometry::formats {

struct CsvCell {
  std::string text;        ///< text without quotes and, when not quoted, without blanks around it
  std::size_t column = 1;  ///< byte at which the field begins, from 1
};

/// The cells of one line without its line break. Fails on a quote that is not closed on its line (a line
/// break inside a field has no place among readings) and on text after a closing quote.
Result<std::vector<CsvCell>> split_row(std::string_view line, char delimiter, std::size_t line_number);

/// What a reader says that finds more than read_budget::row_cells.
std::unexpected<Error> fail_row_cells(TextPosition at);

struct RowShape {
  std::size_t expected = 0;  ///< cells in the header
  std::size_t needed = 0;    ///< cells up to the last column that is read; spreadsheets cut off empty cells behind it
  std::size_t header_line = 0;
  std::size_t line = 0;  ///< line of the row
  char delimiter = ',';
  bool cut_off = false;  ///< the row is the last and has no line break
};

/// Fails on a row with more or fewer cells than the header, saying what the likely reason is. Empty cells
/// beyond the header (a delimiter at the end of every row) are let pass.
Result<void> check_cell_count(const std::vector<CsvCell>& cells, const RowShape& shape);

/// A run number from 1 to read_budget::runs; "1.0", as data frames write it, is 1.
Result<std::size_t> run_number(std::string_view cell, TextPosition at);

/// The delimiter of a header line: whichever of semicolon, tab and comma parts it into most cells.
char delimiter_of(std::string_view header_line);

/// Up or down by the words, arrows and signs in use, in any case; nothing for other words.
std::optional<Direction> direction_from(std::string_view word);

/// What direction_from() reads, for messages.
inline constexpr std::string_view direction_words =
    "up, down, ↑, ↓, +, -, forward, backward, reverse, positive or negative";

/// Whether a cell says that there is no reading: empty, "-", "NA", "n/a", "null".
bool is_missing(std::string_view cell);

/// Reads the numbers of one file, all with the same decimal mark, which the first number with one decides.
/// With comma as delimiter a comma is never a decimal mark: "1,250" could be a thousand.
class NumberReader {
 public:
  explicit NumberReader(char delimiter) : delimiter_(delimiter) {}

  /// Fails on anything but one finite number.
  Result<double> read(std::string_view cell, TextPosition at);

  /// '.', ',' or, as long as no number had one, nothing.
  std::optional<char> mark() const { return mark_; }

 private:
  Result<void> settle_mark(char mark, std::string_view cell, TextPosition at);

  char delimiter_;
  std::optional<char> mark_;
  TextPosition mark_at_;
};

}  // namespace axiometry::formats
