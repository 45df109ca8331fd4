// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/time/iso_date.h"

#include <fmt/format.h>

#include <optional>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/written_date.h"

namespace axiometry {
namespace {

using std::chrono::year_month;
using std::chrono::year_month_day;

struct DateParts {
  std::string_view year, month, day;
};

std::optional<year_month> month_of(std::string_view year, std::string_view month) {
  const auto y = parse_count(year);
  const auto m = parse_count(month);
  if (!y || !m || year.size() != 4 || month.size() > 2) return {};
  const auto named = std::chrono::year(static_cast<int>(*y)) / std::chrono::month(static_cast<unsigned>(*m));
  return named.ok() ? std::optional(named) : std::nullopt;
}

/// Empty of a day that does not exist.
std::string date_of(const DateParts& parts) {
  const auto month = month_of(parts.year, parts.month);
  const auto d = parse_count(parts.day);
  if (!month || !d || parts.day.size() > 2) return {};
  const year_month_day date = *month / std::chrono::day(static_cast<unsigned>(*d));
  return date.ok() ? iso_day(date) : "";
}

std::optional<year_month> named_month(std::string_view text) {
  for (const char mark : {'-', '/'})
    if (const auto parts = text::split(text, mark); parts.size() == 2)
      if (const auto month = month_of(parts[0], parts[1])) return month;
  for (const char mark : {'/', '.'})
    if (const auto parts = text::split(text, mark); parts.size() == 2)
      if (const auto month = month_of(parts[1], parts[0])) return month;
  return written_month(text);
}

}  // namespace

std::string iso_day(const year_month_day& day) {
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

std::string iso_date(std::string_view raw) {
  const std::string_view text = text::trim(raw);
  const std::string_view day = text.substr(0, text.find_first_of("T ,;"));
  std::string date;
  for (const char mark : {'-', '/'})
    if (const auto parts = text::split(day, mark); parts.size() == 3 && date.empty())
      date = date_of({parts[0], parts[1], parts[2]});
  if (const auto parts = text::split(day, '.'); parts.size() == 3) date = date_of({parts[2], parts[1], parts[0]});
  // Who wrote the year last would have 19 or 20 for a month.
  if (day.size() == 8 && date.empty()) date = date_of({day.substr(0, 4), day.substr(4, 2), day.substr(6)});
  if (!date.empty()) return date;
  const auto written = written_date(text);
  return written ? iso_day(*written) : "";
}

bool is_no_day(std::string_view raw) {
  const std::string_view text = text::trim(raw);
  const std::string_view day = text.substr(0, text.find_first_of("T ,;"));
  const auto written = [](const DateParts& parts) {
    return parts.year.size() == 4 && parts.month.size() <= 2 && parts.day.size() <= 2 && parse_count(parts.year) &&
           parse_count(parts.month) && parse_count(parts.day);
  };
  bool is_written = false;
  for (const char mark : {'-', '/', '.'})
    if (const auto parts = text::split(day, mark); parts.size() == 3)
      is_written =
          written(mark == '.' ? DateParts{parts[2], parts[1], parts[0]} : DateParts{parts[0], parts[1], parts[2]});
  return is_written && iso_date(text).empty();
}

NamedDays named_days(std::string_view raw) {
  if (const std::string day = iso_date(raw); !day.empty()) return {day, day};
  const auto month = named_month(text::trim(raw));
  if (!month) return {};
  return {iso_day(*month / std::chrono::day(1)), iso_day(*month / std::chrono::last)};
}

}  // namespace axiometry
