// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/base/time/moment.h"
#include "axiometry/model/temperatures.h"

/// What data loggers and weather stations write: a time and one or more temperatures in every line.
namespace axiometry::formats {

/// Sensor by its name in the log, and its role: "machine", "equipment" or "air".
using SensorRoles = std::vector<std::pair<std::string, std::string>>;

/// Text of columns, perhaps below a preamble, separated by semicolons, tabs, commas or blanks; decimal point or comma.
///
/// - Time: a moment (ISO 8601, or day.month.year), a date and a time of day in two columns, a time of day alone, or
///   seconds (another unit as the header says). Newest first is turned round.
/// - Temperatures: °C, K or °F by the header. With any unit in the header, only columns with such a unit count; what
///   else stands there (humidity, pressure, …) is told in the remarks.
/// - A reading that is empty, a word of no value ("-", "NaN", "err", …) or outside −60 … 100 °C is left out and told.
/// - Roles are those given, else what a word of the name says ("air", "room", "bed", "scale", "laser", …), else
///   air; either is told.
///
/// Fails, with the line, on a text without such lines, on a header that tells no temperature, on times that run back
/// and forth, on a line without its time, on a day/month/year with slashes (nobody knows which is the month), on one
/// column for many sensors, on a role for a sensor that is not there, two for one or an unknown role, on more than 64
/// sensors, on a line of more than 16 KiB, and on more than 64 MiB.
Result<TemperatureLog> read_temperature_log(std::string_view bytes, const SensorRoles& roles = {});

/// The sensors' names by which roles are given, whether they tell a role or not. Reads no further than to the first
/// line of readings, and fails as read_temperature_log() does up to there.
Result<std::vector<std::string>> sensors_of_log(std::string_view bytes);

/// The last of these, which can be asked before anything is read.
Result<void> check_log_size(std::size_t bytes);

}  // namespace axiometry::formats
