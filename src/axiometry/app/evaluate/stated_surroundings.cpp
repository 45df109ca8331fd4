// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/stated_surroundings.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/iso230_2/rules/rules.h"

namespace axiometry::app {
namespace {

constexpr double alike_air_C = 1.0;  // °C: two thermometers of a hall, half a degree each

/// Of a change or a difference what a thermometer is off by itself falls out.
double alike_of(const iso230_2::EnvironmentItem& item) { return item.clause == "7" ? alike_air_C : 0.5; }

Result<void> check_order(const std::optional<Temperature>& lowest, const std::optional<Temperature>& highest,
                         bool agreed) {
  if (!lowest || !highest || lowest->in_celsius() <= highest->in_celsius()) return {};
  const std::string low = format_exact(lowest->in_celsius()), high = format_exact(highest->in_celsius());
  return fail(
      agreed ? fmt::format("found an agreed lowest temperature of {} °C above the highest of {} °C", low, high)
             : fmt::format("found a lowest temperature of the air of {} °C above the highest of {} °C, expected it "
                           "below",
                           low, high));
}

/// Whether the log knows all of the time that an item is stated for.
bool known_whole(const iso230_2::EnvironmentItem& item, const iso230_2::TestEnvironment& logged) {
  const auto& share = item.key == "rate_before_C_per_h"  ? logged.before
                      : item.key == "machine_gradient_C" ? logged.on_machine
                                                         : logged.during;
  return share && share->complete();
}

/// Whether what it saw was certainly within that time.
bool known_within(const iso230_2::EnvironmentItem& item, const iso230_2::TestEnvironment& logged) {
  return item.key == "rate_before_C_per_h" ? logged.before.has_value() : logged.during && logged.during->end_told;
}

}  // namespace

bool states_surroundings(const Metadata& metadata) {
  return metadata.surroundings != StatedEnvironment{} || metadata.agreed != AgreedEnvironment{};
}

Result<void> check_surroundings(const Metadata& metadata) {
  AXIOMETRY_TRY_VOID(check_order(metadata.surroundings.lowest, metadata.surroundings.highest, false));
  return check_order(metadata.agreed.lowest, metadata.agreed.highest, true);
}

std::vector<iso230_2::Finding> contradicted_by_test(const Metadata& metadata) {
  std::vector<iso230_2::Finding> findings;
  const auto tell = [&](std::string message) {
    findings.push_back({"environment-statement-contradicts", "4.1", iso230_2::Severity::missing, std::move(message)});
  };
  const auto &lowest = metadata.surroundings.lowest, &highest = metadata.surroundings.highest;
  for (const auto& own : {metadata.environment.air_temperature_start, metadata.environment.air_temperature_end}) {
    if (!own) continue;
    if (lowest && own->in_celsius() < lowest->in_celsius() - alike_air_C)
      tell(
          fmt::format("found air of {} °C stated at the start or the end of the test below its lowest temperature "
                      "stated, {} °C, expected figures of one test",
                      format_exact(own->in_celsius()), format_exact(lowest->in_celsius())));
    if (highest && own->in_celsius() > highest->in_celsius() + alike_air_C)
      tell(
          fmt::format("found air of {} °C stated at the start or the end of the test above its highest temperature "
                      "stated, {} °C, expected figures of one test",
                      format_exact(own->in_celsius()), format_exact(highest->in_celsius())));
  }
  return findings;
}

std::vector<iso230_2::Finding> contradicted_by_log(const StatedEnvironment& stated,
                                                   const iso230_2::TestEnvironment& logged) {
  std::vector<iso230_2::Finding> findings;
  const auto figures = iso230_2::stated_figures(stated);
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const iso230_2::EnvironmentItem& item = logged.items[k];
    if (!figures[k] || !item.measured) continue;
    const double beyond = item.lower_limit ? *figures[k] - *item.measured : *item.measured - *figures[k];
    const double alike = alike_of(item);
    const bool seen_beyond = beyond > alike && known_within(item, logged);
    const bool never_seen = beyond < -alike && known_whole(item, logged);
    if (!seen_beyond && !never_seen) continue;
    findings.push_back(
        {"environment-statement-contradicts", std::string(item.clause), iso230_2::Severity::missing,
         fmt::format("found {}: {} {} stated, expected what the temperature log has, {} {}, which counts unless what "
                     "is stated exceeds what was agreed",
                     iso230_2::rules::within_sentence(item.title), format_exact(*figures[k]), item.unit,
                     format_fixed(*item.measured, 2), item.unit)});
  }
  return findings;
}

}  // namespace axiometry::app
