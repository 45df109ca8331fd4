// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"

/// Columns of a text recording: which one is the time, which the position, in which units.
namespace axiometry::formats {

struct Unit;

struct SampleColumns {
  char delimiter = ' ';  ///< ' ' stands for any blanks and tabs
  std::size_t time = 0;
  std::size_t position = 1;
  bool stamps = false;            ///< the time is a point in time, else a number
  double seconds_per_unit = 1.0;  ///< seconds of a time that is a number
  double position_factor = 1.0;   ///< mm or ° per unit
  double position_divisor = 1.0;  ///< so that 0.1 µm is exactly 0.0001 mm
  bool by_header = false;
  bool time_has_unit = false;      ///< of a header: whether it names one
  bool position_has_unit = false;  ///< likewise
  const Unit* unit = nullptr;      ///< unit that the header names
  std::string name{};              ///< what the header calls the column that is read, without its unit
};

/// The cells of a line, without quotes about them; with blanks as delimiter, date and time of day that a blank parts
/// are one cell.
std::vector<std::string_view> cells_of(std::string_view line, char delimiter);

/// A number with a decimal point, or with a comma where the comma is not the delimiter.
std::optional<double> number_of(std::string_view cell, char delimiter);

/// The delimiter of a line: semicolon, tab, comma, else blanks; "0,5 12,25" is separated by its blanks.
char sample_delimiter(std::string_view line);

/// From the first line with values, when there was no header: of the columns beside the time the one that was stated,
/// else the only one. Nothing when it is no such line, or has other columns or no values.
std::optional<SampleColumns> columns_by_values(std::string_view line, std::optional<std::size_t> stated);

struct PositionChoice {
  std::optional<std::size_t> stated{};  ///< 0 is the first column beside the time
  bool at_standstill = false;           ///< a deviation is as good, and some column is taken: RecordingOptions
  bool in_any_unit = false;             ///< whether units that are not read will do too, to recognise a layout
};

/// From a header line: names such as time, t, zeit, position, x with units behind them as "_mm", "[mm]", "(mm)",
/// "/mm" or alone. The position is the column that was stated, else the only one, else the only one that has a unit of
/// position, or is called one, and is no setpoint and no deviation; a unit does not count where another column is
/// called the position. Fails on a unit of the other kind of axis or that is not read (cm, gon), on a column that
/// nobody stated and that is called a temperature or the like, and where time or position cannot be told.
Result<SampleColumns> columns_by_header(std::string_view line, AxisKind kind, PositionChoice choice);

/// The same of readings of another quantity, or of a trigger, as they stand there: the column that was stated, else the
/// only one. Fails on a unit in brackets that is not known.
Result<SampleColumns> value_columns_by_header(std::string_view line, std::optional<std::size_t> stated);

}  // namespace axiometry::formats
