// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/environment/environment.h"

#include <fmt/format.h>

#include <algorithm>

namespace axiometry::iso230_2 {
namespace {

constexpr std::string_view before_key = "rate_before_C_per_h", gradient_key = "machine_gradient_C";
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

EnvironmentStanding standing_of(const EnvironmentItem& item, bool complete) {
  using enum EnvironmentStanding;
  if (!item.measured) return not_measured;
  if (!item.agreed) return not_agreed;
  const double beyond = item.lower_limit ? *item.agreed - *item.measured : *item.measured - *item.agreed;
  if (beyond > at_limit) return exceeded;
  return complete ? kept : known_in_part;
}

/// Whether what is measured is known of all the time that it is stated for.
struct Completeness {
  bool during = true;
  bool before = true;
  bool gradient = true;
};

Completeness find_shares(TestEnvironment& environment, const TemperatureLog& log, const TimeStretch& test,
                         const std::optional<double>& hours_before) {
  const double whole_h = test.length_s() / hour_in_s;
  const RecordedShare on_machine{recorded_s(log.sensors, "machine", test, true) / hour_in_s, whole_h, test.end_told};
  environment.during = RecordedShare{recorded_s(log.sensors, "air", test) / hour_in_s, whole_h, test.end_told};
  environment.before = RecordedShare{hours_before.value_or(0.0), hours_before_test};
  return {environment.during->complete(), environment.before->complete(), on_machine.complete()};
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
  return recorded_h > 0.0 && whole_h - recorded_h <= std::max(minute_h, 0.01 * whole_h);
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
  environment.items = {
      {"lowest_C", "Lowest temperature of the air", "°C", "7", true, in_celsius(found.lowest),
       in_celsius(agreed.lowest)},
      {"highest_C", "Highest temperature of the air", "°C", "7", false, in_celsius(found.highest),
       in_celsius(agreed.highest)},
      {"rate_C_per_h", "Change per hour, during the test", "°C/h", "4.1", false, found.rate, agreed.rate},
      {before_key, "Change per hour, in the twelve hours before", "°C/h", "4.1", false, found.rate_before, agreed.rate},
      {gradient_key, "Gradient over the machine", "°C", "4.1", false, in_kelvin(found.machine_gradient),
       in_kelvin(agreed.machine_gradient)},
  };
  // Where the test was is not known: what was recorded may not be all of it.
  Completeness complete{false, false, false};
  if (test) complete = find_shares(environment, log, *test, found.hours_before);
  for (EnvironmentItem& item : environment.items) {
    const bool before = item.key == before_key, gradient = item.key == gradient_key;
    item.standing = standing_of(item, before ? complete.before : gradient ? complete.gradient : complete.during);
  }
  return environment;
}

std::vector<std::string> gaps_of(const TestEnvironment& environment, const NumberStyle& numbers) {
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
    gaps.push_back(
        fmt::format("the temperature of the air was recorded in {} h of the {} h of the test; what it was in "
                    "the rest is not known",
                    hours(during->recorded_h), hours(during->whole_h)));
  if (environment.before && !environment.before->complete())
    gaps.push_back(
        fmt::format("the temperature of the air was recorded in {} h of the twelve hours before the test, of "
                    "which clause 4.1 asks for all",
                    hours(environment.before->recorded_h)));
  return gaps;
}

}  // namespace axiometry::iso230_2
