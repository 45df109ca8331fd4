// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/iso_date.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"

namespace axiometry {
namespace {

std::optional<std::string> date_text(std::string_view year, std::string_view month, std::string_view day) {
  const auto y = parse_count(year);
  const auto m = parse_count(month);
  const auto d = parse_count(day);
  if (!y || !m || !d || year.size() != 4 || month.size() > 2 || day.size() > 2) return {};
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(*y)),
                                         std::chrono::month(static_cast<unsigned>(*m)),
                                         std::chrono::day(static_cast<unsigned>(*d))};
  if (!date.ok()) return {};
  return fmt::format("{:04}-{:02}-{:02}", *y, *m, *d);
}

}  // namespace

std::string iso_date(std::string_view raw) {
  const std::string_view text = text::trim(raw);
  const std::string_view day = text.substr(0, text.find_first_of("T ,;"));
  for (const char mark : {'-', '/'})
    if (const auto parts = text::split(day, mark); parts.size() == 3)
      if (const auto date = date_text(parts[0], parts[1], parts[2])) return *date;
  if (const auto parts = text::split(day, '.'); parts.size() == 3)
    if (const auto date = date_text(parts[2], parts[1], parts[0])) return *date;
  return {};
}

}  // namespace axiometry
