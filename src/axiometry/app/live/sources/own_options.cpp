// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/sources/own_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr double longest_give_up_s = 86'400.0;

std::unexpected<Error> bad_option(std::string_view name, std::string_view found, std::string_view expected) {
  return fail(fmt::format("{}: found {}, expected {}", name, text::quoted(found), expected));
}

Result<void> put_own(const std::string& name, const std::string& value, OwnOptions& own) {
  if (name == "speed") {
    const auto speed = parse_number(value);
    const auto speeds = simulation_speeds();
    if (!speed || std::ranges::find(speeds, *speed) == speeds.end())
      return bad_option(name, value, fmt::format("one of {}", fmt::join(speeds, ", ")));
    own.speed = *speed;
  } else if (name == "preset") {
    own.preset = value;
  } else if (name == "seed") {
    own.seed = parse_count(value);
    if (!own.seed || *own.seed >= seed_limit) return bad_option(name, value, "a whole number below 2^53");
  } else if (name == "size") {
    own.size = parse_number(value);
    if (!own.size || !(*own.size > 0.0) || *own.size > largest_motion_size)
      return bad_option(name, value, fmt::format("a number above 0 up to {}", largest_motion_size));
  } else {
    const auto seconds = parse_number(value);
    if (!seconds || *seconds < 0.0 || *seconds > longest_give_up_s)
      return bad_option(name, value, fmt::format("seconds up to {}", longest_give_up_s));
    own.give_up = Duration::s(*seconds);
  }
  return {};
}

}  // namespace

Result<OwnOptions> own_options(const std::vector<std::pair<std::string, std::string>>& options,
                               CaptureSource::Kind kind) {
  OwnOptions own;
  for (const auto& [name, value] : options) {
    if (value.empty()) continue;  // a field that was left empty
    const bool of_simulator = name == "speed" || name == "preset" || name == "seed" || name == "size";
    if (of_simulator && kind != CaptureSource::Kind::simulator)
      return fail(fmt::format("found {}, expected it with the simulator only", name));
    if (of_simulator || name == "give-up")
      AXIOMETRY_TRY_VOID(put_own(name, value, own));
    else
      own.others.emplace_back(name, value);
  }
  return own;
}

SimulatedMotionCapture simulated_motion_of(const OwnOptions& own, const SimulatedPace& pace) {
  return {own.preset, own.size.value_or(usual_motion_size), own.seed.value_or(1), pace};
}

void put_seed(std::vector<std::pair<std::string, std::string>>& options, std::uint64_t seed) {
  std::erase_if(options, [](const auto& option) { return option.first == "seed"; });
  options.emplace_back("seed", fmt::format("{}", seed));
}

}  // namespace axiometry::app
