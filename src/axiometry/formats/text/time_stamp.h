// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace axiometry::formats {

/// Seconds since 1970-01-01 of a time stamp after ISO 8601, within 1 µs: "2026-03-07T23:30:43.5+01:00", with a blank
/// for T, without a zone (taken as UTC, for differences only). Nothing for other text, and for a day or an hour that
/// does not exist.
std::optional<double> time_stamp_s(std::string_view text);

}  // namespace axiometry::formats
