// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/units.h"

/// What the names in a CSV header mean: "target_mm", "Deviation (µm)", "run 3 up [um]", "↑1_um", "2-".
namespace axiometry::formats {

enum class ColumnRole {
  test,       ///< name of the test, in files of many
  target,     ///< target position
  direction,  ///< direction of approach
  run,        ///< number of the run
  reading,    ///< deviation or measured position; in wide files with direction or run in its name
  ignored,    ///< time stamps, comments, temperatures, running numbers
  unknown,
};

struct Column {
  ColumnRole role = ColumnRole::unknown;
  std::string name;           ///< as it stands in the header
  std::size_t at_column = 1;  ///< byte of the line
  Measured measured = Measured::deviation;
  const Unit* unit = nullptr;          ///< unit of targets and readings; null when not stated or unknown
  std::string unit_text;               ///< as it stands in the name, empty when there is none
  std::optional<Direction> direction;  ///< stated in the name of a reading
  std::optional<std::size_t> run;      ///< stated in the name of a reading, from 1
};

/// The head of a long table, as we write it.
constexpr std::string_view long_table_head(AxisKind kind) {
  return kind == AxisKind::linear ? "target_mm,direction,run,deviation_um"
                                  : "target_deg,direction,run,deviation_arcsec";
}

/// Every column of a header. A column "position" is the measured position beside a target, the target
/// otherwise; measured positions beside deviations are ignored.
std::vector<Column> columns_from(const std::vector<CsvCell>& header);

/// Units stated once for the whole file, for headers that do not state them.
struct DefaultUnits {
  const Unit* reading = nullptr;
  const Unit* target = nullptr;
};

/// Which columns were passed over by their names, a sentence without full stop; nothing where none was.
std::optional<std::string> passed_over_text(const std::vector<Column>& columns);

/// The common checks: known columns only, exactly one target, units where they are needed, one unit for
/// all readings and of the same kind as that of the targets. Fails with the place in the header.
Result<void> check_columns(std::vector<Column>& columns, const DefaultUnits& defaults, std::size_t line);

/// Number of columns up to the last one that is not ignored.
std::size_t needed_columns(const std::vector<Column>& columns);

/// Index of the only column in this role; nothing when there is none. Fails on a second one.
Result<std::optional<std::size_t>> only_column(const std::vector<Column>& columns, ColumnRole role, std::size_t line);

}  // namespace axiometry::formats
