// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/temperature_flags.h"

#include <fmt/format.h>

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/surroundings.h"
#include "cli/flags/option_text.h"

namespace axiometry::cli {
namespace {

/// A temperature, a rate or a difference that nobody means below absolute zero or above what burns.
double within_reason(const std::string& flag, double x, double least) {
  constexpr double most = hottest_hall_C;
  if (!(x >= least && x <= most))
    throw UsageError(flag, fmt::format("found {}, expected a number from {} to {}", format_exact(x),
                                       format_exact(least), format_exact(most)));
  return x;
}

struct AgreedFlag {
  std::string name;
  std::string unit;
  std::string description;
  double least = 0.0;
  std::function<void(double)> put;
};

void add_agreed_flag(const Verb& verb, const AgreedFlag& flag, const std::string& group) {
  const auto put = [name = flag.name, least = flag.least, put = flag.put](double x) {
    put(within_reason(name, x, least));
  };
  add_number(verb, {flag.name, flag.unit, flag.description}, put)->group(group);
}

}  // namespace

void add_temperature_flags(const Verb& verb, app::TemperatureRequest& request, const std::string& prefix,
                           const std::string& group) {
  verb.add_option("--began", request.began, "Moment of the first reading of the test, as 2026-03-02T09:00")
      ->type_name("MOMENT")
      ->group(group);
  verb.add_option(
          "--ended", request.ended,
          prefix.empty()
              ? "Moment of its last reading; without it the end of the log is taken for it, and no limit is called kept"
              : "Moment of its last reading; without it the times of the readings tell it, or else the end of the log "
                "is taken for it, and no limit is called kept")
      ->type_name("MOMENT")
      ->group(group);
  verb.add_option_function<std::vector<std::string>>(
          "--sensor",
          [&request](const std::vector<std::string>& pairs) {
            for (const std::string& pair : pairs) {
              const std::size_t equals = pair.rfind('=');
              if (equals == std::string::npos)
                throw UsageError("--sensor", fmt::format("found {}, expected NAME=ROLE", text::quoted(pair)));
              request.roles.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
            }
          },
          "What a sensor is of where its name does not say so: machine, equipment, air or none; may be repeated")
      ->type_name("NAME=ROLE")
      ->one_at_a_time()
      ->group(group);
  constexpr double coldest = coldest_hall_C;
  auto& agreed = request.agreed;
  const std::vector<AgreedFlag> flags = {
      {"--" + prefix + "lowest", "C", "Lowest temperature of the air that the parties agreed on, °C (7)", coldest,
       [&agreed](double x) { agreed.lowest = Temperature::celsius(x); }},
      {"--" + prefix + "highest", "C", "Highest temperature of the air that the parties agreed on, °C (7)", coldest,
       [&agreed](double x) { agreed.highest = Temperature::celsius(x); }},
      {"--" + prefix + "rate", "C_PER_H",
       "Change of the air's temperature that the parties agreed on, °C per hour, in the twelve hours before the test "
       "and during it (4.1, 7)",
       0.0, [&agreed](double x) { agreed.rate = x; }},
      {"--" + prefix + "gradient", "C", "Difference between places on the machine that the parties agreed on, °C (4.1)",
       0.0, [&agreed](double x) { agreed.machine_gradient = TemperatureDifference::kelvin(x); }}};
  for (const AgreedFlag& flag : flags) add_agreed_flag(verb, flag, group);
}

}  // namespace axiometry::cli
