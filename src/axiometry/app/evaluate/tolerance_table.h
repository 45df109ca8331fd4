// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/evaluate/tolerance_text.h"
#include "axiometry/base/result.h"
#include "axiometry/model/series.h"
#include "axiometry/standards/iso230_2/verdict/tolerance.h"

/// Files of tolerance tables: named sets of limits by the kind of axis and its travel, so that one file serves a
/// whole hall of machines. CSV with one row per band of travel; docs/howto/tolerances.md describes it.
namespace axiometry::app {

/// One row: the limits for axes up to a travel.
struct ToleranceBand {
  std::string name;  ///< name of the table it belongs to
  AxisKind kind = AxisKind::linear;
  std::optional<Position> travel_max;  ///< absent: for any travel above the other bands
  std::vector<iso230_2::Tolerance> limits;
  std::optional<RuleText> rule;
  std::size_t line = 0;  ///< number of the line in the file
};

std::string travel_text(const ToleranceBand& band);  ///< "up to 500 mm", "any travel"

/// A whole file.
struct ToleranceTable {
  std::string file;
  std::string sha256;
  std::vector<ToleranceBand> bands;  ///< no two of the same name, kind and travel; in the order of the file
};

/// Reads the bytes of a file, comma, semicolon or tab between the columns, decimal point or comma:
///   name          of the table; a row for each of its bands
///   kind          linear or rotary
///   travel_up_to  largest measured travel of the band, mm or °, itself included; empty: all above
///   unit          of the limits: um, mm, nm, arcsec or deg
///   rule          may be left out: as --rule
///   A, E, R_up …  the limits; an empty cell is no limit
/// Fails, with line and column, on an unknown, missing or repeated column, on a cell that is not what its column
/// says, on a unit or rule of the other kind of axis, on a row without a limit and on a band given twice.
Result<ToleranceTable> read_tolerance_table(std::string_view bytes, const std::string& file);

/// The same from a file; at most 1 MiB. Errors carry its name.
Result<ToleranceTable> open_tolerance_table(const std::string& file);

/// A file and perhaps the name of a table in it, as in "limits.csv:Grinder". A file that exists under the whole text
/// is meant as a whole, so that a colon in its name does no harm.
struct ToleranceTableName {
  std::string file;
  std::string name;  ///< may be empty
};
ToleranceTableName parse_table_name(const std::string& text);

/// The band for an axis: of the table so named (case does not matter), or of the only one there is when the name is
/// empty, the first whose travel is not exceeded. Fails, listing what there is, when the name is unknown or needed,
/// the table has no row for this kind of axis, or the travel is above all bands.
Result<const ToleranceBand*> select_band(const ToleranceTable& table, std::string_view name, AxisKind kind,
                                         const Series& series);

}  // namespace axiometry::app
