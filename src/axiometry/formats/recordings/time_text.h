// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

/// Points in time as recordings spell them.
namespace axiometry::formats {

/// Nanoseconds since 1970-01-01 00:00 UTC of "2026-11-21T12:34:56.789Z", "2026-11-21 12:34:56,789",
/// "2026-11-21T12:34:56+02:00"; without a zone UTC is assumed, since only differences count. Nothing for other text and
/// for days that do not exist. Digits beyond the ninth of a second are cut off. Years 1900 to 2200.
std::optional<std::int64_t> parse_time_stamp(std::string_view text);

/// Seconds of one unit: s, sec, ms, us, µs, ns, min, h, in any case; nothing for other words.
std::optional<double> seconds_per_unit(std::string_view unit);

}  // namespace axiometry::formats
