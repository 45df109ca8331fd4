// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/csv/csv_preamble.h"
#include "axiometry/formats/table/generic_cells.h"
#include "axiometry/formats/table/import_profile.h"

/// Where the table stands in the text. Private to the generic importer.
namespace axiometry::formats::generic {

/// The names in a header line that has `count` columns; fewer or none when it has another number. Between blanks names
/// may hold single blanks, and units in brackets belong to the name before.
std::vector<std::string> names_in(std::string_view line, Delimiter delimiter, std::size_t count);

struct TableRegion {
  std::span<const PlainLine> above;  ///< the header, when there is one
  std::vector<PlainLine> header;     ///< its lines, without a comment mark before them
  std::vector<PlainLine> rows;       ///< rows without blank lines and comments
};

/// The table that the profile describes. Fails when no line holds the names of its columns.
Result<TableRegion> find_table(const ImportProfile& profile, std::span<const PlainLine> lines);

/// What the lines above a table tell about the test.
struct LinesAbove {
  Preamble preamble;
  LinesPassedOver passed_over;
};

/// `# key: value`, "Machine: Mill 5" and "Machine;Mill 5" with the keys of csv-long; what does not fit its field is
/// passed over and counted.
LinesAbove read_lines_above(std::span<const PlainLine> lines, AxisKind kind, char decimal_mark);

/// Whether a line is a comment.
bool is_comment(std::string_view line, std::string_view mark);

}  // namespace axiometry::formats::generic
