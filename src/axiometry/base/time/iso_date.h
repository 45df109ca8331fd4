// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <string_view>

/// Dates as people write them.
namespace axiometry {

/// "2014-05-15", as dates are written here.
std::string iso_day(const std::chrono::year_month_day& day);

/// "2014-05-15" of what begins like that, of "20140515", "15.05.2014" and "2014/5/15", and of a written_date(), such as
/// "15 May 2014"; nothing of other text and of a day that does not exist. A date that may be read in two ways,
/// "05/06/2014", is other text.
std::string iso_date(std::string_view text);

/// Whether a text is written as a day, with a year of four digits, that does not exist: "2026-02-30", "30.02.2026".
bool is_no_day(std::string_view text);

/// The first and the last day that a text names: both iso_date() of a day, and of a month, "2014-05", "2014/5",
/// "05/2014", "05.2014" or "May 2014", its ends. Both empty where it names neither.
struct NamedDays {
  std::string first;
  std::string last;
};
NamedDays named_days(std::string_view text);

}  // namespace axiometry
