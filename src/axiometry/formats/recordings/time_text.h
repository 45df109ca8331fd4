// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "axiometry/base/time/moment.h"

/// Points in time as recordings spell them.
namespace axiometry::formats {

using axiometry::parse_time_stamp;

/// Seconds of one unit: s, sec, ms, us, µs, ns, min, h, in any case; nothing for other words.
std::optional<double> seconds_per_unit(std::string_view unit);

}  // namespace axiometry::formats
