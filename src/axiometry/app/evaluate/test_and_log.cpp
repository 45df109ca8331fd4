// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/test_and_log.h"

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/text/says_nothing.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/base/time/moment.h"
#include "axiometry/standards/environment/ambient_course.h"

namespace axiometry::app {

std::optional<iso230_2::Finding> other_day(const Test& test, const EvaluatedTemperatures& found) {
  constexpr std::int64_t hour_ns = 3'600'000'000'000, day_ns = 24 * hour_ns, zones_ns = 14 * hour_ns;
  if (found.began.empty()) return std::nullopt;
  const std::string& stated = test.metadata.conditions.date;
  const std::string day = iso_date(stated);
  const auto midnight = moment_of(day + "T00:00"), began = moment_of(found.began);
  // That the date cannot be read is told of the test itself; when it began somebody has said.
  if (day.empty() && !text::says_nothing(stated) && !text::says_none(stated))
    return iso230_2::Finding{"environment-day-not-read", "4.1", iso230_2::Severity::note,
                             fmt::format("found a test dated {}, which names no day that can be read: nobody can check "
                                         "that its temperatures, of {}, are of that day",
                                         stated, found.began)};
  if (day.empty() || !midnight || !began) return std::nullopt;
  const auto ended = moment_of(found.ended.empty() ? found.ended_by_readings : found.ended);
  const std::int64_t last = ended ? ended->ns : began->ns, either_way = began->zoned ? zones_ns : 0;
  if (midnight->ns <= last + either_way && began->ns < midnight->ns + day_ns + either_way) return std::nullopt;
  return iso230_2::Finding{"environment-other-day", "4.1", iso230_2::Severity::missing,
                           fmt::format("found a test dated {}, expected the day of its temperatures, {}: nobody knows "
                                       "whose these are",
                                       day, found.began)};
}

std::vector<iso230_2::Finding> contradicted_temperatures(const Test& test, const EvaluatedTemperatures& found) {
  std::vector<iso230_2::Finding> findings;
  if (!found.test) return findings;
  const Environment& environment = test.metadata.environment;
  struct Compared {
    std::string_view role;
    std::optional<Temperature> stated;
    bool at_end;
  };
  const auto compare = [&](std::span<const TemperatureCourse> sensors, std::string_view logged_role, Compared c) {
    constexpr double alike_C = 1.0;
    if (!c.stated || (c.at_end && !found.test->end_told)) return;
    const auto logged = extremes_at(sensors, logged_role, c.at_end ? found.test->end_s : found.test->begin_s);
    const double own = c.stated->in_celsius();
    if (!logged || (own >= logged->low - alike_C && own <= logged->high + alike_C)) return;
    findings.push_back(
        {"environment-log-contradicts", "4.1", iso230_2::Severity::missing,
         fmt::format(
             "found {:.1f} °C stated of the {} at the {} of the test, expected what the temperature log has then, "
             "{:.1f} to {:.1f} °C",
             own, c.role, c.at_end ? "end" : "beginning", logged->low, logged->high)});
  };
  const std::span<const TemperatureCourse> all = found.log.sensors;
  constexpr std::string_view air = "air";
  compare(all, air, {air, environment.air_temperature_start, false});
  compare(all, air, {air, environment.air_temperature_end, true});
  for (const TemperatureSensor& sensor : environment.sensors) {
    const std::string role = text::to_lower(sensor.role);
    const auto compare_both = [&](std::span<const TemperatureCourse> sensors, std::string_view logged_role) {
      compare(sensors, logged_role, {role, sensor.start, false});
      compare(sensors, logged_role, {role, sensor.end, true});
    };
    if (role == air) compare_both(all, air);
    if ((role != "machine" && role != "equipment") || text::trim(sensor.location).empty()) continue;
    for (const TemperatureCourse& logged : all)
      if (text::equal_ignoring_case(text::trim(sensor.location), text::trim(logged.location)))
        compare_both(std::span(&logged, 1), logged.role);
  }
  return findings;
}

}  // namespace axiometry::app
