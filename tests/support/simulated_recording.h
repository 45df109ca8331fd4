// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/simulation/presets.h"
#include "axiometry/simulation/simulate.h"
#include "axiometry/standards/iso230_2/plan/plan.h"

/// A plan, and what an instrument says while an axis walks it.
namespace axiometry::testing_support {

/// Three targets, once there and back: fifteen seconds of a machine for each run.
inline Plan short_plan(std::size_t runs = 1) {
  iso230_2::PlanRequest request;
  request.axis.name = "X";
  request.axis.travel_begin = Position::native(0.0);
  request.axis.travel_end = Position::native(60.0);
  request.count = 3;
  request.runs = runs;
  request.feed = 6000.0;
  request.dwell = Duration::s(1.0);
  request.warm_up_runs = 0;
  request.seed = 1;
  return *iso230_2::make_plan(request);
}

/// What the simulator says of that plan, whole.
inline std::string recording(const std::string& preset, std::uint64_t seed, std::size_t runs = 1) {
  const Plan plan = short_plan(runs);
  const simulation::Request request{.plan = plan,
                                    .axis = simulation::find_preset(preset)->make(plan),
                                    .departures = {},
                                    .seed = seed,
                                    .fault = preset};
  auto encoder = *app::RecordingEncoder::make(app::RawLayout::text, {plan.axis.kind, 0, 100.0, Length::nm(632.991)});
  std::string bytes = encoder.head();
  static_cast<void>(simulation::record(request, {.rate = 100.0}, [&](std::span<const Sample> samples) -> Result<void> {
    for (const Sample& sample : samples) encoder.append(bytes, sample);
    return {};
  }));
  return bytes;
}

/// The recording line by line, with the time of each.
struct TimedLine {
  std::string text;
  double time_s = 0.0;
};

/// Of "time-position", "camonitor-stream" or "umd".
inline std::vector<TimedLine> lines_of(const std::string& layout, std::size_t runs = 1, std::uint64_t seed = 3) {
  std::vector<TimedLine> lines;
  const std::string whole = recording("good", seed, runs);
  std::string_view rest = whole;
  std::size_t number = 0;
  for (rest.remove_prefix(rest.find("\n0") + 1); !rest.empty(); rest.remove_prefix(rest.find('\n') + 1)) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    const double time_s = *parse_number(line.substr(0, line.find(',')));
    const std::string position(line.substr(line.find(',') + 1));
    const auto ms = static_cast<long long>(std::llround(time_s * 1e3));
    if (layout == "time-position") lines.push_back({std::string(line) + "\n", time_s});
    if (layout == "camonitor-stream")
      lines.push_back(
          {fmt::format("X 2026-11-21 12:{:02}:{:02}.{:03} {}\n", ms / 60'000 % 60, ms / 1000 % 60, ms % 1000, position),
           time_s});
    if (layout == "umd") {
      const auto counts = std::llround(*parse_number(position) * 1e4);
      lines.push_back({fmt::format("0 0 {} 0 0 {} 0 0\n", counts, ++number), time_s});
    }
  }
  return lines;
}

}  // namespace axiometry::testing_support
