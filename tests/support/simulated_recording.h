// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/raw_recording.h"
#include "axiometry/simulation/presets.h"
#include "axiometry/simulation/simulate.h"
#include "axiometry/standards/iso230_2_plan.h"

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

}  // namespace axiometry::testing_support
