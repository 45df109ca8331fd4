// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Points in time as people and instruments spell them.
namespace axiometry {

/// Nanoseconds since 1970-01-01 00:00 UTC of "2026-11-21T12:34:56.789Z", "2026-11-21 12:34:56,789",
/// "2026-11-21T12:34:56+02:00", "…+02"; without a zone UTC is assumed, since only differences count. Nothing for other
/// text and for days that do not exist. Digits beyond the ninth of a second are cut off. Years 1900 to 2200.
std::optional<std::int64_t> parse_time_stamp(std::string_view text);

/// Seconds since 1970-01-01 of such a text, within 1 µs: of one whose date has dashes and whose clock tells seconds, in
/// any year of four digits. Blanks around it do not count.
std::optional<double> time_stamp_s(std::string_view text);

/// Seconds from one stamp to another in nanoseconds, however far apart.
double seconds_between(std::int64_t from_ns, std::int64_t to_ns);

/// A moment as somebody wrote it. Two of them can be compared when both tell their zone or neither does.
struct Moment {
  std::int64_t ns = 0;  ///< nanoseconds since 1970-01-01 00:00, UTC where the zone is told, else local
  bool zoned = false;

  double seconds_since(const Moment& other) const { return seconds_between(other.ns, ns); }
};

/// "2026-03-02T09:00", with seconds or a zone where told, or "02.03.2026 09:00". Nothing for other text.
std::optional<Moment> moment_of(std::string_view text);

/// As moment_of() reads it: "2026-03-02T09:00:00Z", without Z where no zone was told; seconds are rounded.
std::string moment_text(const Moment& moment);

/// Seconds since midnight of "9:05", "09:05:10.5".
std::optional<double> time_of_day_s(std::string_view cell);

/// Days since 1970-01-01 of "2026-03-02", "02.03.2026".
std::optional<long> day_of(std::string_view cell);

}  // namespace axiometry
