// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/reading_limits.h"
#include "axiometry/base/result.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/units.h"

/// What the tables of a tracking interferometer have in common: heads that state a unit, and lines.
namespace axiometry::formats {

struct TableHead {
  std::string name;  ///< lower case, parts separated by one blank
  std::string unit;  ///< as it stands there, or empty
};

/// "x_mm", "X [mm]", "length difference (µm)", "time_s": name and unit. Behind a blank or a low line only a known unit
/// of files or "s" is one.
TableHead table_head(std::string_view head);

/// The names in a head as it is written, "x_mm,y_mm,z_mm": N of them.
template <std::size_t N>
constexpr std::array<std::string_view, N> names_of(std::string_view head) {
  std::array<std::string_view, N> names;
  for (std::string_view& name : names) {
    name = head.substr(0, head.find(','));
    head.remove_prefix(std::min(head.size(), name.size() + 1));
  }
  return names;
}

/// "length difference", "dl", "ΔL" and the other names of L_i − L_0.
bool is_length_difference(std::string_view name);

/// The unit of length of a column. Fails when it states none, or one of another kind; `canonical` is how it could be
/// written, such as "x_mm".
Result<const Unit*> length_unit(const CsvCell& head, const TableHead& named, std::string_view canonical,
                                std::size_t line);

/// The unit of angle of a column, likewise.
Result<const Unit*> angle_unit(const CsvCell& head, const TableHead& named, std::string_view canonical,
                               std::size_t line);

/// In mm. Fails beyond largest_stated; `cell` is what stands there.
Result<double> length_in_mm(const Unit& unit, double value, std::string_view cell, TextPosition at);

/// "passed over the columns "name", "temperature"". Needs a name.
std::string passed_over(std::span<const std::string> columns);

struct TableLine {
  std::string_view text;     ///< line with the blanks at its ends, since a tab there parts cells
  std::string_view content;  ///< line without them, never empty
  std::size_t number = 0;    ///< number of the line, from 1
  bool has_break = true;     ///< false for the last line of a file that ends within it
};

/// Calls take(line) for every line that is not blank, until one fails. A spreadsheet's "sep=;" above all others is no
/// line of the table.
template <typename Take>
Result<void> for_table_lines(std::string_view text, const Take& take) {
  bool first = true;
  for (std::size_t begin = 0, number = 1; begin < text.size(); ++number) {
    const std::size_t line_break = text.find('\n', begin);
    const std::size_t end = std::min(line_break, text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    begin = end + 1;
    const std::string_view content = text::trim(line);
    if (content.empty()) continue;
    const bool hint = first && text::to_lower(content.substr(0, 4)) == "sep=";
    first = false;
    if (!hint) AXIOMETRY_TRY_VOID(take(TableLine{line, content, number, line_break != std::string_view::npos}));
  }
  return {};
}

}  // namespace axiometry::formats
