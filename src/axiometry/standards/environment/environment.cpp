// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/environment/environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/model/sensor_extremes.h"

namespace axiometry::iso230_2 {
namespace {

constexpr std::string_view rate_key = "rate_C_per_h", before_key = "rate_before_C_per_h",
                           gradient_key = "machine_gradient_C";
constexpr double hour_in_s = 3600.0;
constexpr double at_limit = 1e-9;  // °C: rounding of a double, far below any display

struct StandingWord {
  std::string_view key;
  std::string_view text;
};
constexpr StandingWord standing_words[] = {
    {"kept", "kept"},
    {"exceeded", "exceeded"},
    {"not-measured", "not measured"},
    {"not-agreed", "no limit agreed"},
    {"known-in-part", "known in part only"},
};

std::optional<double> in_celsius(const std::optional<Temperature>& t) {
  return t ? std::optional(t->in_celsius()) : std::nullopt;
}
std::optional<double> in_kelvin(const std::optional<TemperatureDifference>& t) {
  return t ? std::optional(t->in_kelvin()) : std::nullopt;
}

/// What each quantity has, in their order.
std::array<std::optional<double>, 5> values_of(const AmbientTemperatures& found) {
  return {in_celsius(found.lowest), in_celsius(found.highest), found.rate, found.rate_before,
          in_kelvin(found.machine_gradient)};
}

/// What the temperatures at the start and at the end of a test tell of it.
StatedEnvironment at_both_ends(const Environment& environment) {
  StatedEnvironment known;
  const auto widen = [](std::optional<Temperature>& lowest, std::optional<Temperature>& highest,
                        const std::optional<Temperature>& t) {
    if (t && (!lowest || t->in_celsius() < lowest->in_celsius())) lowest = t;
    if (t && (!highest || t->in_celsius() > highest->in_celsius())) highest = t;
  };
  widen(known.lowest, known.highest, environment.air_temperature_start);
  widen(known.lowest, known.highest, environment.air_temperature_end);
  for (const auto end : {&TemperatureSensor::start, &TemperatureSensor::end}) {
    std::optional<Temperature> coldest, warmest;  // extremes over the places on the machine at that time
    std::size_t places = 0;
    for (const TemperatureSensor& sensor : environment.sensors) {
      if (text::equal_ignoring_case(sensor.role, "air")) widen(known.lowest, known.highest, sensor.*end);
      if (!text::equal_ignoring_case(sensor.role, "machine") || !(sensor.*end)) continue;
      widen(coldest, warmest, sensor.*end);
      ++places;
    }
    if (places < 2) continue;
    const double difference = warmest->in_celsius() - coldest->in_celsius();
    if (!known.machine_gradient || difference > known.machine_gradient->in_kelvin())
      known.machine_gradient = TemperatureDifference::kelvin(difference);
  }
  return known;
}

/// Of what was found that which nobody can take for anything but the test or the twelve hours before it.
AmbientTemperatures certain_of(const AmbientTemperatures& found, std::span<const TemperatureCourse> sensors,
                               const std::optional<TimeStretch>& test) {
  if (!test) return {};
  if (test->end_told) return found;
  return ambient_of(sensors, TimeStretch{test->begin_s, test->begin_s, false});  // its beginning and the time before
}

bool beyond(const EnvironmentItem& item, double value) {
  return (item.lower_limit ? *item.agreed - value : value - *item.agreed) > at_limit;
}

/// Of two figures of one quantity that which lies further on its limit's side.
std::optional<double> further(const EnvironmentItem& item, std::optional<double> a, std::optional<double> b) {
  if (!a || !b) return a ? a : b;
  return item.lower_limit ? std::min(*a, *b) : std::max(*a, *b);
}

void judge_item(EnvironmentItem& item, const std::optional<double>& certain, bool complete) {
  using enum EnvironmentStanding;
  if (!item.measured) return;
  if (!item.agreed) {
    item.standing = not_agreed;
  } else if (certain && beyond(item, *certain)) {
    item.standing = exceeded;
    item.measured = certain;
  } else {
    item.perhaps_exceeded = beyond(item, *item.measured);
    item.standing = complete && !item.perhaps_exceeded ? kept : known_in_part;
  }
}

/// Nothing is measured of them yet.
std::vector<EnvironmentItem> items_of(const AgreedEnvironment& agreed) {
  return {
      {"lowest_C", "Lowest temperature of the air", "°C", "7", true, {}, in_celsius(agreed.lowest)},
      {"highest_C", "Highest temperature of the air", "°C", "7", false, {}, in_celsius(agreed.highest)},
      {rate_key, "Change per hour, during the test", "°C/h", "4.1", false, {}, agreed.rate},
      {before_key, "Change per hour, in the twelve hours before", "°C/h", "4.1", false, {}, agreed.rate},
      {gradient_key, "Gradient over the machine", "°C", "4.1", false, {}, in_kelvin(agreed.machine_gradient)},
  };
}

/// Whether what is measured is known of all the time that it is stated for.
struct Completeness {
  bool during = true;
  bool before = true;
  bool gradient = true;
};

Completeness find_shares(TestEnvironment& environment, const TemperatureLog& log, const TimeStretch& test) {
  const auto share = [&](std::string_view role, const TimeStretch& stretch) {
    LeastRecorded least = least_recorded(log.sensors, role, stretch);
    return RecordedShare{least.recorded_s / hour_in_s, stretch.length_s() / hour_in_s, stretch.end_told,
                         std::move(least.sensor)};
  };
  environment.during = share("air", test);
  environment.before = share("air", {test.begin_s - hours_before_test * hour_in_s, test.begin_s});
  const auto on_machine = std::ranges::count_if(
      log.sensors, [](const TemperatureCourse& course) { return text::equal_ignoring_case(course.role, "machine"); });
  if (on_machine > 1) environment.on_machine = share("machine", test);
  const auto known_at = [&](double time_s) {
    return ambient_of(log.sensors, TimeStretch{time_s, time_s}).lowest.has_value();
  };
  environment.ends_recorded = test.end_told && known_at(test.begin_s) && known_at(test.end_s);
  return {environment.during->complete(), environment.before->complete(),
          environment.on_machine && environment.on_machine->complete()};
}

/// What of the test was not recorded of the air, in words.
std::string gap_during(const RecordedShare& share, const std::string& recorded, const std::string& whole) {
  if (!share.sensor.empty())
    return fmt::format(
        "temperature sensor {} recorded {} h of the {} h of the test; what it was there in the rest is "
        "not known",
        text::quoted(share.sensor), recorded, whole);
  return fmt::format(
      "the temperature of the air was recorded in {} h of the {} h of the test; what it was in the rest "
      "is not known",
      recorded, whole);
}

std::string gap_before(const RecordedShare& share, const std::string& recorded) {
  if (!share.sensor.empty())
    return fmt::format(
        "temperature sensor {} recorded {} h of the twelve hours before the test, of which clause 4.1 "
        "asks for all",
        text::quoted(share.sensor), recorded);
  return fmt::format(
      "the temperature of the air was recorded in {} h of the twelve hours before the test, of which "
      "clause 4.1 asks for all",
      recorded);
}

std::string gap_on_machine(const RecordedShare& share, const std::string& recorded, const std::string& whole) {
  if (!share.sensor.empty()) return gap_during(share, recorded, whole);
  return fmt::format("the gradient over the machine is known in {} h of the {} h of the test", recorded, whole);
}

}  // namespace

std::string_view standing_key(EnvironmentStanding standing) {
  return standing_words[static_cast<std::size_t>(standing)].key;
}

std::string_view standing_text(EnvironmentStanding standing) {
  return standing_words[static_cast<std::size_t>(standing)].text;
}

bool RecordedShare::gapless() const {
  constexpr double minute_h = 1.0 / 60.0;
  return recorded_h > 0.0 && whole_h - recorded_h <= minute_h;
}

bool TestEnvironment::exceeded() const {
  return std::ranges::any_of(
      items, [](const EnvironmentItem& item) { return item.standing == EnvironmentStanding::exceeded; });
}

bool TestEnvironment::open() const {
  return std::ranges::any_of(items, [](const EnvironmentItem& item) {
    return item.agreed && item.standing != EnvironmentStanding::kept && item.standing != EnvironmentStanding::exceeded;
  });
}

TestEnvironment test_environment(const TemperatureLog& log, const std::optional<TimeStretch>& test,
                                 const AgreedEnvironment& agreed) {
  const AmbientTemperatures found = ambient_of(log.sensors, test);
  TestEnvironment environment;
  environment.placed = test.has_value();
  environment.items = items_of(agreed);
  // Where the test was is not known: what was recorded may not be all of it.
  Completeness complete{false, false, false};
  if (test) complete = find_shares(environment, log, *test);
  // What a sensor of the air tells of its highest and lowest temperature between readings tells no change per hour.
  const bool any_extremes = std::ranges::any_of(log.sensors, [](const TemperatureCourse& course) {
    return text::equal_ignoring_case(course.role, "air") && names_extremes(course.location);
  });
  const auto measured = values_of(found), certain = values_of(certain_of(found, log.sensors, test));
  for (std::size_t k = 0; k < measured.size(); ++k) {
    EnvironmentItem& item = environment.items[k];
    item.measured = measured[k];
    const bool during = complete.during && (item.key != rate_key || found.rate_of_every_sensor);
    judge_item(item, certain[k],
               item.key == before_key     ? complete.before && !any_extremes
               : item.key == gradient_key ? complete.gradient
                                          : during);
  }
  return environment;
}

std::vector<std::optional<double>> stated_figures(const StatedEnvironment& stated) {
  return {in_celsius(stated.lowest), in_celsius(stated.highest), stated.rate, stated.rate_before,
          in_kelvin(stated.machine_gradient)};
}

TestEnvironment with_statement(TestEnvironment environment, const Metadata& stated) {
  const auto of_all = stated_figures(stated.surroundings), of_ends = stated_figures(at_both_ends(stated.environment));
  for (std::size_t k = 0; k < of_all.size(); ++k) {
    EnvironmentItem& item = environment.items[k];
    const std::optional<double> figure = further(item, of_all[k], of_ends[k]);
    const bool worse = figure && item.agreed && beyond(item, *figure);
    if (!figure || item.standing == EnvironmentStanding::exceeded || (item.measured && !worse)) continue;
    item.measured = figure;
    item.stated = true;
    item.perhaps_exceeded = false;
    judge_item(item, figure, of_all[k].has_value());
  }
  environment.soaked_h = stated.surroundings.soaked_h;
  return environment;
}

TestEnvironment stated_environment(const Metadata& stated) {
  TestEnvironment environment;
  environment.items = items_of(stated.agreed);
  environment.placed = true;
  return with_statement(std::move(environment), stated);
}

std::vector<std::string> time_gaps_of(const TestEnvironment& environment, const NumberStyle& numbers) {
  const auto hours = [&](double h) { return format_fixed(h, 2, numbers); };
  std::vector<std::string> gaps;
  if (!environment.placed)
    gaps.emplace_back(
        "nobody said when the test was: all of the log counts as the test, and nothing is known of the twelve hours "
        "before it");
  const auto& during = environment.during;
  const bool nothing_of_it = during && !(during->whole_h > 0.0);
  if (during && !during->end_told)
    gaps.emplace_back(nothing_of_it ? "nobody said when the test ended, and the log ends no later than the test began"
                                    : "nobody said when the test ended: the end of the log is taken for it");
  if (during && !nothing_of_it && !during->gapless())
    gaps.push_back(gap_during(*during, hours(during->recorded_h), hours(during->whole_h)));
  const auto& on_machine = environment.on_machine;
  if (on_machine && !nothing_of_it && !on_machine->gapless())
    gaps.push_back(gap_on_machine(*on_machine, hours(on_machine->recorded_h), hours(on_machine->whole_h)));
  if (environment.before && !environment.before->complete())
    gaps.push_back(gap_before(*environment.before, hours(environment.before->recorded_h)));
  return gaps;
}

std::vector<std::string> gaps_of(const TestEnvironment& environment, const NumberStyle& numbers) {
  std::vector<std::string> gaps = time_gaps_of(environment, numbers);
  if (std::ranges::any_of(environment.items, &EnvironmentItem::perhaps_exceeded))
    gaps.emplace_back("an agreed limit was exceeded, and nobody can say whether that was during the test");
  return gaps;
}

}  // namespace axiometry::iso230_2
