// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/time_text.h"

#include <chrono>

#include "axiometry/base/text.h"

namespace axiometry::formats {
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

}  // namespace

std::optional<std::int64_t> parse_time_stamp(std::string_view text) {
  using namespace std::chrono;
  Scanner s{text};
  const unsigned y = s.number(4);
  s.demand("-/");
  const unsigned m = s.number(2);
  s.demand("-/");
  const unsigned d = s.number(2);
  s.demand("T t");
  const unsigned hour = s.number(2);
  s.demand(":");
  const unsigned minute = s.number(2);
  const unsigned second = s.take(":") ? s.number(2) : 0;
  const std::int64_t fraction = s.take(".,") ? fraction_ns(s) : 0;
  std::int64_t offset_minutes = 0;
  if (!s.take("Zz") && !s.rest.empty()) {
    const bool west = s.rest.front() == '-';
    s.demand("+-");
    offset_minutes = s.number(2) * 60;
    s.take(":");
    offset_minutes += s.number(2);
    if (west) offset_minutes = -offset_minutes;
  }
  const year_month_day date(year(static_cast<int>(y)), month(m), day(d));
  if (!s.good || !s.rest.empty() || !date.ok() || y < 1900 || y > 2200 || hour > 23 || minute > 59 || second > 60)
    return std::nullopt;
  const std::int64_t days = sys_days(date).time_since_epoch().count();
  const std::int64_t seconds = ((days * 24 + hour) * 60 + minute - offset_minutes) * 60 + second;
  return seconds * 1'000'000'000 + fraction;
}

std::optional<double> seconds_per_unit(std::string_view unit) {
  struct Spelling {
    std::string_view text;
    double seconds;
  };
  constexpr Spelling spellings[] = {{"s", 1.0},   {"sec", 1.0}, {"seconds", 1.0}, {"ms", 1e-3},  {"us", 1e-6},
                                    {"µs", 1e-6}, {"μs", 1e-6}, {"ns", 1e-9},     {"min", 60.0}, {"h", 3600.0}};
  for (const Spelling& s : spellings)
    if (text::equal_ignoring_case(s.text, unit)) return s.seconds;
  return std::nullopt;
}

}  // namespace axiometry::formats
