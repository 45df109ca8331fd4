// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/time/moment.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"

namespace axiometry {
namespace {

/// Takes characters from the front of a text; `good` turns false with the first that does not fit.
struct Scanner {
  std::string_view rest;
  bool good = true;

  unsigned number(std::size_t digits) {
    unsigned value = 0;
    for (std::size_t k = 0; k < digits; ++k) {
      good = good && k < rest.size() && rest[k] >= '0' && rest[k] <= '9';
      if (!good) return 0;
      value = value * 10 + static_cast<unsigned>(rest[k] - '0');
    }
    rest.remove_prefix(digits);
    return value;
  }

  bool take(std::string_view any_of) {
    if (rest.empty() || any_of.find(rest.front()) == any_of.npos) return false;
    rest.remove_prefix(1);
    return true;
  }

  void demand(std::string_view any_of) { good = take(any_of) && good; }
};

std::int64_t fraction_ns(Scanner& s) {
  std::int64_t ns = 0;
  std::int64_t place = 100'000'000;
  bool any = false;
  for (; !s.rest.empty() && s.rest.front() >= '0' && s.rest.front() <= '9'; s.rest.remove_prefix(1)) {
    ns += place * (s.rest.front() - '0');
    place /= 10;
    any = true;
  }
  s.good = s.good && any;
  return ns;
}

/// With a point or a comma.
std::optional<double> seconds_of(std::string_view text) {
  std::string with_point(text);
  std::ranges::replace(with_point, ',', '.');
  return parse_number(with_point);
}

/// "Z", "+01:00", "-0530", "+01" or nothing, in minutes east of Greenwich.
std::int64_t zone_minutes(Scanner& s) {
  if (s.take("Zz") || s.rest.empty()) return 0;
  const bool west = s.rest.front() == '-';
  s.demand("+-");
  const std::int64_t hours = s.number(2);
  const bool minutes_told = s.take(":") || !s.rest.empty();
  const std::int64_t minutes = minutes_told ? s.number(2) : 0;
  s.good = s.good && minutes <= 59 && hours * 60 + minutes <= (west ? 12 : 14) * 60;
  return (west ? -1 : 1) * (hours * 60 + minutes);
}

/// A time stamp as it was written.
struct WrittenStamp {
  unsigned year = 0;
  std::int64_t seconds = 0;   ///< whole ones since 1970-01-01 00:00 UTC
  std::int64_t fraction = 0;  ///< fraction of a second, in ns
  bool dashes = false;        ///< between the numbers of its date
  bool seconds_told = false;  ///< by its clock
};

std::optional<WrittenStamp> written_stamp(std::string_view text) {
  using namespace std::chrono;
  Scanner s{text};
  const unsigned y = s.number(4);
  s.demand("-/");
  const unsigned m = s.number(2);
  s.demand("-/");
  const unsigned d = s.number(2);
  s.demand("T t");
  while (s.take(" ")) continue;
  const unsigned hour = s.number(2);
  s.demand(":");
  const unsigned minute = s.number(2);
  const bool seconds_told = s.take(":");
  const unsigned second = seconds_told ? s.number(2) : 0;
  const std::int64_t fraction = s.take(".,") ? fraction_ns(s) : 0;
  const std::int64_t zone = zone_minutes(s);
  const year_month_day date(year(static_cast<int>(y)), month(m), day(d));
  if (!s.good || !s.rest.empty() || !date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  const std::int64_t days = sys_days(date).time_since_epoch().count();
  return WrittenStamp{.year = y,
                      .seconds = ((days * 24 + hour) * 60 + minute - zone) * 60 + second,
                      .fraction = fraction,
                      .dashes = text[4] == '-' && text[7] == '-',
                      .seconds_told = seconds_told};
}

}  // namespace

std::optional<std::int64_t> parse_time_stamp(std::string_view text) {
  const auto stamp = written_stamp(text);
  if (!stamp || stamp->year < 1900 || stamp->year > 2200) return std::nullopt;
  return stamp->seconds * 1'000'000'000 + stamp->fraction;
}

std::optional<double> time_stamp_s(std::string_view text) {
  const auto stamp = written_stamp(text::trim(text));
  if (!stamp || !stamp->dashes || !stamp->seconds_told) return std::nullopt;
  return static_cast<double>(stamp->seconds) + static_cast<double>(stamp->fraction) / 1e9;
}

std::optional<double> time_of_day_s(std::string_view cell) {
  const auto parts = text::split(cell, ':');
  if (parts.size() < 2 || parts.size() > 3 || parts[0].empty() || parts[0].size() > 2) return std::nullopt;
  const auto hour = parse_count(parts[0]), minute = parse_count(parts[1]);
  const auto second = parts.size() == 3 ? seconds_of(parts[2]) : std::optional(0.0);
  if (!hour || !minute || !second || parts[1].size() != 2 || *hour > 23 || *minute > 59) return std::nullopt;
  if (*second < 0.0 || *second >= 61.0) return std::nullopt;
  return static_cast<double>(*hour * 3600 + *minute * 60) + *second;
}

std::optional<long> day_of(std::string_view cell) {
  const bool points = cell.find('.') != cell.npos;
  const auto parts = text::split(cell, points ? '.' : '-');
  if (parts.size() != 3) return std::nullopt;
  const std::string_view y = points ? parts[2] : parts[0], d = points ? parts[0] : parts[2];
  if (y.size() != 4 || parts[1].size() > 2 || d.size() > 2) return std::nullopt;
  const auto year = parse_count(y), month = parse_count(parts[1]), day = parse_count(d);
  if (!year || !month || !day) return std::nullopt;
  const std::chrono::year_month_day date(std::chrono::year(static_cast<int>(*year)),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day)));
  if (!date.ok() || *year < 1900 || *year > 2200) return std::nullopt;
  return static_cast<long>(std::chrono::sys_days(date).time_since_epoch().count());
}

double seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
  // Two int64 may lie up to 2^64 − 1 apart, which only the unsigned type holds.
  const auto later = static_cast<std::uint64_t>(std::max(from_ns, to_ns));
  const auto earlier = static_cast<std::uint64_t>(std::min(from_ns, to_ns));
  const double apart_s = static_cast<double>(later - earlier) / 1e9;
  return to_ns >= from_ns ? apart_s : -apart_s;
}

std::optional<Moment> moment_of(std::string_view text) {
  text = text::trim(text);
  if (const auto ns = parse_time_stamp(text)) {
    const std::string_view clock = text.substr(std::min<std::size_t>(text.size(), 11));
    return Moment{*ns, clock.find_first_of("Zz+-") != clock.npos};
  }
  const std::size_t blank = text.find_first_of(" T");
  if (blank == text.npos) return std::nullopt;
  const auto day = day_of(text.substr(0, blank));
  const auto seconds = time_of_day_s(text::trim(text.substr(blank + 1)));
  if (!day || !seconds) return std::nullopt;
  return Moment{
      static_cast<std::int64_t>(*day) * 86'400'000'000'000 + static_cast<std::int64_t>(std::llround(*seconds * 1e9)),
      false};
}

std::string moment_text(const Moment& moment) {
  using namespace std::chrono;
  const sys_seconds second{round<seconds>(nanoseconds(moment.ns))};
  const sys_days day = floor<days>(second);
  const hh_mm_ss clock(second - day);
  return fmt::format("{}T{:02}:{:02}:{:02}{}", iso_day(day), clock.hours().count(), clock.minutes().count(),
                     clock.seconds().count(), moment.zoned ? "Z" : "");
}

}  // namespace axiometry
