// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string_view>

/// Dates with the name of their month: "12 Nov 2026", "Nov. 12, 2026", "12. November 2026", "1er décembre 2026",
/// "12-NOV-26", "2026 Nov 12", "Thu Nov 12 09:30:00 2026". Names of months are English, German and French, whole or as
/// they are shortened, in any case, with or without their accents. Other people read only iso_date() of this.
namespace axiometry {

/// Of a year of four digits, 1900 to 2199, or of two after day and month with nothing behind them but a time: those are
/// 1970 to 2069. Nothing of a day that does not exist, and of a text with a second month or year, which may be a range.
std::optional<std::chrono::year_month_day> written_date(std::string_view text);

/// "November 2026", "2026 Nov": of a year of four digits alone, because "Nov 26" may be a day.
std::optional<std::chrono::year_month> written_month(std::string_view text);

}  // namespace axiometry
