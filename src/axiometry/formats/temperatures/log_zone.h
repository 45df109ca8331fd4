// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"

/// Time zones that stand in a column of their own. Private to this folder.
namespace axiometry::formats {

/// A column where a time zone may stand.
struct ZoneColumn {
  std::size_t place = 0;
  std::string name;      ///< its head, quoted; "column 2" without one
  bool by_head = false;  ///< its head says so ("timezone", "UTC offset"): whatever stands there is one
  bool digits = false;   ///< "+0100" is no number there
};

/// Nothing for a column that holds the names of loggers, sensors or axes, such as "GMT-7" and "Z".
std::optional<ZoneColumn> zone_column(std::size_t place, std::string_view head, bool digits);

/// Fails on a line of readings with a time zone in one of these columns: "+01:00", "UTC", "GMT-7", "CET", "Z",
/// "Europe/Berlin", "+0100".
Result<void> check_zones(std::span<const std::string_view> cells, std::span<const ZoneColumn> columns);

}  // namespace axiometry::formats
