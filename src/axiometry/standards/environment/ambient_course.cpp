// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/environment/ambient_course.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "axiometry/base/text/text.h"
#include "axiometry/model/sensor_extremes.h"

namespace axiometry {
namespace {

constexpr double hour_s = 3600.0;

struct Point {
  double time_s = 0.0;
  double celsius = 0.0;
};
/// Recorded without a break, in order of time; never empty.
using Piece = std::vector<Point>;

double between(const Point& a, const Point& b, double time_s) {
  if (!(b.time_s > a.time_s)) return b.celsius;
  return a.celsius + (b.celsius - a.celsius) * (time_s - a.time_s) / (b.time_s - a.time_s);
}

/// What a sensor recorded within a stretch, straight to its ends.
std::vector<Piece> pieces_within(const TemperatureCourse& course, const TimeStretch& stretch) {
  std::vector<Piece> pieces;
  bool goes_on = false;
  const auto see = [&](Point point) {
    if (!goes_on) pieces.emplace_back();
    pieces.back().push_back(point);
    goes_on = true;
  };
  for (std::size_t k = 0; k < course.times_s.size(); ++k) {
    const Point own{course.times_s[k], course.celsius[k]};
    if (k > 0) {
      const Point last{course.times_s[k - 1], course.celsius[k - 1]};
      const bool recorded = own.time_s - last.time_s <= longest_unrecorded_s;
      goes_on = goes_on && recorded;
      if (recorded && last.time_s < stretch.begin_s && own.time_s > stretch.begin_s)
        see({stretch.begin_s, between(last, own, stretch.begin_s)});
      if (recorded && last.time_s < stretch.end_s && own.time_s > stretch.end_s)
        see({stretch.end_s, between(last, own, stretch.end_s)});
    }
    if (own.time_s >= stretch.begin_s && own.time_s <= stretch.end_s) see(own);
  }
  return pieces;
}

double length_of(const std::vector<Piece>& pieces) {
  double length = 0.0;
  for (const Piece& piece : pieces) length += piece.back().time_s - piece.front().time_s;
  return length;
}

double range_of(const Piece& piece) {
  const auto [low, high] = std::ranges::minmax(piece, {}, &Point::celsius);
  return high.celsius - low.celsius;
}

/// The piece with a point at a time within it.
Piece with_time(Piece piece, double time_s) {
  const auto after = std::ranges::lower_bound(piece, time_s, {}, &Point::time_s);
  if (after == piece.begin() || after == piece.end() || after->time_s == time_s) return piece;
  const Point own{time_s, between(*std::prev(after), *after, time_s)};
  piece.insert(after, own);
  return piece;
}

/// The piece with a point an hour before and an hour after each of its points: between neighbours the greatest change
/// within an hour can only lie at one of these.
Piece with_hours(const Piece& piece) {
  Piece all = piece;
  for (const double shift : {-hour_s, hour_s}) {
    std::size_t at = 0;
    for (const Point& point : piece) {
      const double time = point.time_s + shift;
      if (time <= piece.front().time_s || time >= piece.back().time_s) continue;
      while (piece[at + 1].time_s < time) ++at;
      all.push_back({time, between(piece[at], piece[at + 1], time)});
    }
  }
  std::ranges::stable_sort(all, {}, &Point::time_s);
  return all;
}

/// The greatest change between two moments at most an hour apart, the later not before `from_s`; of time in proportion
/// to the points.
double greatest_change(const Piece& piece, double from_s) {
  const Piece all = with_hours(with_time(piece, from_s));
  std::deque<std::size_t> lowest, highest;  // candidates of the window that ends at `k`
  double greatest = 0.0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    while (!lowest.empty() && all[lowest.back()].celsius >= all[k].celsius) lowest.pop_back();
    while (!highest.empty() && all[highest.back()].celsius <= all[k].celsius) highest.pop_back();
    lowest.push_back(k);
    highest.push_back(k);
    const double from = all[k].time_s - hour_s * (1.0 + 1e-12);
    while (all[lowest.front()].time_s < from) lowest.pop_front();
    while (all[highest.front()].time_s < from) highest.pop_front();
    if (all[k].time_s < from_s) continue;
    greatest = std::max(
        {greatest, all[highest.front()].celsius - all[k].celsius, all[k].celsius - all[lowest.front()].celsius});
  }
  return greatest;
}

/// Of changes that end at `from_s` or later.
std::optional<double> rate_of(const std::vector<Piece>& pieces, double from_s) {
  std::optional<double> rate;
  const auto see = [&](double x) { rate = std::max(rate.value_or(0.0), x); };
  constexpr double whole = hour_s * (1.0 - 1e-9);
  const auto length = [](const Piece& piece) { return piece.back().time_s - piece.front().time_s; };
  const bool any_hour = std::ranges::any_of(pieces, [&](const Piece& piece) { return length(piece) >= whole; });
  for (const Piece& piece : pieces) {
    if (any_hour)
      see(greatest_change(piece, from_s));
    else if (length(piece) >= shortest_for_a_rate_s)
      see(range_of(piece) * hour_s / length(piece));
  }
  return rate;
}

bool is_of(const TemperatureCourse& course, std::string_view role) {
  return text::equal_ignoring_case(course.role, role);
}

/// At a moment that lies within what is recorded; NaN elsewhere. `at` goes on with growing times.
double value_at(const TemperatureCourse& course, std::size_t& at, double time_s) {
  while (at + 1 < course.times_s.size() && course.times_s[at + 1] <= time_s) ++at;
  const Point here{course.times_s[at], course.celsius[at]};
  if (here.time_s == time_s) return here.celsius;
  if (time_s < here.time_s || at + 1 == course.times_s.size()) return std::numeric_limits<double>::quiet_NaN();
  const Point next{course.times_s[at + 1], course.celsius[at + 1]};
  if (next.time_s - here.time_s > longest_unrecorded_s) return std::numeric_limits<double>::quiet_NaN();
  return between(here, next, time_s);
}

/// Largest difference between two of them at one moment. It lies at a reading of one of them.
std::optional<double> greatest_difference(const std::vector<const TemperatureCourse*>& sensors,
                                          const TimeStretch& stretch) {
  std::vector<double> times;
  for (const TemperatureCourse* sensor : sensors)
    for (const Piece& piece : pieces_within(*sensor, stretch))
      for (const Point& point : piece) times.push_back(point.time_s);
  std::ranges::sort(times);
  times.erase(std::ranges::unique(times).begin(), times.end());
  std::vector<std::size_t> at(sensors.size(), 0);
  std::optional<double> greatest;
  for (const double time : times) {
    std::size_t known = 0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t k = 0; k < sensors.size(); ++k) {
      const double own = value_at(*sensors[k], at[k], time);
      if (std::isnan(own)) continue;
      ++known;
      low = std::min(low, own);
      high = std::max(high, own);
    }
    if (known > 1) greatest = std::max(greatest.value_or(0.0), high - low);
  }
  return greatest;
}

}  // namespace

std::optional<TemperatureExtremes> extremes_of(const TemperatureCourse& course) {
  if (course.celsius.empty()) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(course.celsius);
  return TemperatureExtremes{low, high};
}

std::optional<TemperatureExtremes> extremes_at(std::span<const TemperatureCourse> sensors, std::string_view role,
                                               double time_s) {
  std::optional<TemperatureExtremes> all;
  for (const TemperatureCourse& course : sensors) {
    if (!is_of(course, role) || course.times_s.empty() || names_extremes(course.location)) continue;
    std::size_t at = 0;
    const double own = value_at(course, at, time_s);
    if (std::isnan(own)) continue;
    all = all ? TemperatureExtremes{std::min(all->low, own), std::max(all->high, own)} : TemperatureExtremes{own, own};
  }
  return all;
}

TimeStretch stretch_of(std::span<const TemperatureCourse> sensors) {
  TimeStretch all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const TemperatureCourse& course : sensors) {
    if (course.times_s.empty()) continue;
    all.begin_s = std::min(all.begin_s, course.times_s.front());
    all.end_s = std::max(all.end_s, course.times_s.back());
  }
  return all.begin_s <= all.end_s ? all : TimeStretch{};
}

LeastRecorded least_recorded(std::span<const TemperatureCourse> sensors, std::string_view role,
                             const TimeStretch& stretch) {
  constexpr double alike_s = 1.0;
  std::optional<LeastRecorded> least;
  double longest = 0.0;
  for (const TemperatureCourse& course : sensors) {
    if (!is_of(course, role)) continue;
    const double own = length_of(pieces_within(course, stretch));
    longest = std::max(longest, own);
    if (!least || own < least->recorded_s) least = LeastRecorded{own, course.location};
  }
  if (!least) return {};
  if (longest - least->recorded_s <= alike_s) least->sensor.clear();
  return *std::move(least);
}

std::optional<TimeStretch> test_in_log(const std::optional<Moment>& began, const std::optional<Moment>& ended,
                                       const TemperatureLog& log) {
  const auto& zero = log.begin;
  if (!zero || !began || zero->zoned != began->zoned || (ended && ended->zoned != zero->zoned)) return std::nullopt;
  const double from = began->seconds_since(*zero);
  const double to = ended ? ended->seconds_since(*zero) : std::max(stretch_of(log.sensors).end_s, from);
  if (ended && to <= from) return std::nullopt;
  return TimeStretch{from, to, ended.has_value()};
}

AmbientTemperatures ambient_of(std::span<const TemperatureCourse> sensors, const std::optional<TimeStretch>& test) {
  const TimeStretch during = test.value_or(stretch_of(sensors));
  TimeStretch for_rate = during;
  if (test) for_rate.begin_s = during.begin_s - hour_s;
  const TimeStretch before{during.begin_s - hours_before_test * hour_s, during.begin_s};
  AmbientTemperatures found;
  std::vector<const TemperatureCourse*> on_machine;
  const auto larger = [](std::optional<double> a, std::optional<double> b) {
    return a && b ? std::max(*a, *b) : a ? a : b;
  };
  for (const TemperatureCourse& course : sensors) {
    if (is_of(course, "machine") && !course.times_s.empty()) on_machine.push_back(&course);
    if (!is_of(course, "air")) continue;
    for (const Piece& piece : pieces_within(course, during))
      for (const Point& point : piece) {
        const Temperature own = Temperature::celsius(point.celsius);
        if (!found.lowest || own.in_celsius() < found.lowest->in_celsius()) found.lowest = own;
        if (!found.highest || own.in_celsius() > found.highest->in_celsius()) found.highest = own;
      }
    // Of extremes between readings nobody knows when they were: they have no rate.
    if (names_extremes(course.location)) {
      found.rate_of_every_sensor = false;
      continue;
    }
    // The time before stands in for no test: only what goes on into it tells its rate.
    auto for_its_rate = pieces_within(course, for_rate);
    std::erase_if(for_its_rate, [&](const Piece& piece) { return piece.back().time_s <= during.begin_s; });
    const auto own_rate = rate_of(for_its_rate, during.begin_s);
    found.rate = larger(found.rate, own_rate);
    found.rate_of_every_sensor = found.rate_of_every_sensor && own_rate.has_value();
    if (test) found.rate_before = larger(found.rate_before, rate_of(pieces_within(course, before), before.begin_s));
  }
  if (on_machine.size() > 1)
    if (const auto difference = greatest_difference(on_machine, during))
      found.machine_gradient = TemperatureDifference::kelvin(*difference);
  return found;
}

}  // namespace axiometry
