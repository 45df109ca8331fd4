// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/base/time/moment.h"
#include "axiometry/formats/temperatures/log_zone.h"

/// Which columns of a temperature log are the time and which are temperatures. Private to temperatures/.
namespace axiometry::formats {

enum class LogTime {
  moment,        ///< date and time of day in one column
  date_and_day,  ///< date and time of day, in two columns
  time_of_day,   ///< alone: no date is known
  number,        ///< seconds or another unit
};

struct LogColumn {
  std::size_t place = 0;
  std::string name;     ///< name without its unit; "column 2" where there is no header
  double factor = 1.0;  ///< °C = factor · value + shift
  double shift = 0.0;
};

struct LogColumns {
  char delimiter = ' ';
  LogTime kind = LogTime::number;
  std::size_t time = 0;
  std::size_t time_of_day = 0;    ///< column of the time of day, of date_and_day
  double seconds_per_unit = 1.0;  ///< seconds of a number
  bool seconds_told = false;      ///< the head tells the unit of a number; else seconds
  std::vector<LogColumn> temperatures;
  std::vector<std::string> passed_over;    ///< heads of columns that are neither
  std::vector<std::string> other_numbers;  ///< heads above a number, of these
  std::vector<ZoneColumn> zones;           ///< where further lines may have a time zone
  bool units_assumed = false;              ///< no head tells a unit: °C
  std::vector<std::string> without_unit;   ///< temperatures by their names where other heads tell a unit: °C
  struct LetterUnit {
    std::string head;
    std::string_view unit;  ///< "K" or "°F"
  };
  std::vector<LetterUnit> letter_units;  ///< heads of which the last letter, F or K, is taken for the unit
};

/// The line that a delimiter parts: a moment that blanks part is one cell.
std::vector<std::string_view> log_cells(std::string_view line, char delimiter);

/// A temperature with a point, or with a comma where that parts no cells: between commas one in quotes, which thousands
/// could have, but no temperature.
std::optional<double> log_number(std::string_view cell, char delimiter);

/// Whether a cell says that its sensor had no value: "", "-", "NaN", "err", …
bool has_no_value(std::string_view cell);

/// The columns by a line of readings and, where there is one, the header above it; without temperatures where that
/// header tells none. Nothing where the line holds no readings. Fails where it does and they cannot be told:
/// a date with slashes, a column of sensors' names.
Result<std::optional<LogColumns>> log_columns(std::string_view line, std::string_view header);

}  // namespace axiometry::formats
