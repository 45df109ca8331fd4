// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "axiometry/app/live/lengths/length_task.h"
#include "axiometry/app/live/sources/played_source.h"
#include "axiometry/base/result.h"

/// The simulator as a source of lengths, so that a capture of them can be tried without instrument and machine.
namespace axiometry::app {

/// What happens to the beam. The machine has errors of a usual size, always the same for one seed.
struct LengthPreset {
  std::string_view id;     ///< "good"
  std::string_view title;  ///< what happens
  std::string_view sign;   ///< how it shows
};
std::span<const LengthPreset> length_presets();  ///< `good` first

struct SimulatedLengthCapture {
  const LengthTask& task;
  std::string_view preset = "good";
  std::uint64_t seed = 1;  ///< seed of the machine, and with the part of all that is drawn
  SimulatedPace pace = {};
};

/// Fails on an unknown preset, and as the simulations do.
Result<Connect> simulated_lengths_source(const SimulatedLengthCapture& capture);

}  // namespace axiometry::app
