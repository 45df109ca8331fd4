// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/test_and_log.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "axiometry/base/iso_date.h"
#include "axiometry/base/moment.h"
#include "axiometry/base/says_nothing.h"
#include "axiometry/base/text.h"
#include "axiometry/standards/environment/ambient_course.h"

namespace axiometry::app {

std::optional<iso230_2::Finding> other_day(const Test& test, const EvaluatedTemperatures& found) {
  constexpr std::int64_t hour_ns = 3'600'000'000'000, day_ns = 24 * hour_ns, zones_ns = 14 * hour_ns;
  const std::string& stated = test.metadata.conditions.date;
  const std::string day = iso_date(stated);
  const auto midnight = moment_of(day + "T00:00"), began = moment_of(found.began);
  if (day.empty() && !text::says_nothing(stated) && !text::says_none(stated))
    return iso230_2::Finding{"environment-other-day", "4.1", iso230_2::Severity::missing,
                             fmt::format("found a test dated {}, which names no day that can be read, and temperatures "
                                         "of {}: nobody knows whose these are",
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
  const auto compare = [&](std::string_view role, const std::optional<Temperature>& stated, bool at_end) {
    constexpr double alike_C = 1.0;
    if (!stated || (at_end && !found.test->end_told)) return;
    const auto logged = extremes_at(found.log.sensors, role, at_end ? found.test->end_s : found.test->begin_s);
    const double own = stated->in_celsius();
    if (!logged || (own >= logged->low - alike_C && own <= logged->high + alike_C)) return;
    findings.push_back(
        {"environment-log-contradicts", "4.1", iso230_2::Severity::missing,
         fmt::format(
             "found {:.1f} °C stated of the {} at the {} of the test, expected what the temperature log has then, "
             "{:.1f} to {:.1f} °C",
             own, role, at_end ? "end" : "beginning", logged->low, logged->high)});
  };
  compare("air", environment.air_temperature_start, false);
  compare("air", environment.air_temperature_end, true);
  for (const TemperatureSensor& sensor : environment.sensors) {
    const std::string role = text::to_lower(sensor.role);
    compare(role, sensor.start, false);
    compare(role, sensor.end, true);
  }
  return findings;
}

}  // namespace axiometry::app
