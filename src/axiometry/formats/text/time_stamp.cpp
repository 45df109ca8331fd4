// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/time_stamp.h"

#include <chrono>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"

namespace axiometry::formats {
namespace {

/// Takes `size` digits off the front; −1 when they are none.
int take_digits(std::string_view& text, std::size_t size) {
  const auto value = text.size() < size ? std::nullopt : parse_count(text.substr(0, size));
  if (!value) return -1;
  text.remove_prefix(size);
  return static_cast<int>(*value);
}

bool take_mark(std::string_view& text, std::string_view marks) {
  if (text.empty() || !marks.contains(text.front())) return false;
  text.remove_prefix(1);
  return true;
}

/// "Z", "+01:00", "-0530" or nothing, in seconds; nothing for anything else.
std::optional<double> zone_s(std::string_view text) {
  if (text.empty() || text == "Z") return 0.0;
  const double sign = text.front() == '-' ? -1.0 : 1.0;
  if (!take_mark(text, "+-")) return std::nullopt;
  const int hours = take_digits(text, 2);
  take_mark(text, ":");
  const int minutes = text.empty() ? 0 : take_digits(text, 2);
  if (hours < 0 || hours > 23 || minutes < 0 || minutes > 59 || !text.empty()) return std::nullopt;
  return sign * (hours * 3600.0 + minutes * 60.0);
}

}  // namespace

std::optional<double> time_stamp_s(std::string_view text) {
  text = text::trim(text);
  const int year = take_digits(text, 4);
  const bool dash = take_mark(text, "-");
  const int month = take_digits(text, 2);
  const bool second_dash = take_mark(text, "-");
  const int day = take_digits(text, 2);
  if (year < 0 || !dash || month < 0 || !second_dash || day < 0 || !take_mark(text, "T ")) return std::nullopt;
  text = text::trim(text);
  const int hour = take_digits(text, 2);
  const bool colon = take_mark(text, ":");
  const int minute = take_digits(text, 2);
  const bool second_colon = take_mark(text, ":");
  const int second = take_digits(text, 2);
  if (hour < 0 || !colon || minute < 0 || !second_colon || second < 0) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  double fraction = 0.0;
  if (!text.empty() && text.front() == '.') {
    const std::size_t end = text.find_first_not_of("0123456789", 1);
    const auto value = parse_number(text.substr(0, end));
    if (!value) return std::nullopt;
    fraction = *value;
    text = end == std::string_view::npos ? std::string_view() : text.substr(end);
  }
  const auto zone = zone_s(text);
  if (!zone) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<double>(days) * 86400.0 + hour * 3600.0 + minute * 60.0 + second + fraction - *zone;
}

}  // namespace axiometry::formats
