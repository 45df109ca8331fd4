// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

/// What a sensor of temperature is of, by its name. Private to temperatures/.
namespace axiometry::formats {

/// "machine", "equipment" or "air" by a word of the sensor's name. Of "air above the bed" the air counts. Nothing for
/// "column 2", the name of a column without a head.
std::optional<std::string_view> sensor_role(std::string_view name);

/// Whether a name tells a temperature that none of the three has: a dew point, a set point, a limit, a coolant.
bool names_no_role(std::string_view name);

}  // namespace axiometry::formats
