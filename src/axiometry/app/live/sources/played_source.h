// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "axiometry/app/live/sources/live_source.h"
#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/base/result.h"
#include "axiometry/model/recording.h"

/// A recording that is made while it is heard, as fast as a machine would make it, or faster.
namespace axiometry::app {

/// Hands all samples to the sink, and ends early where that fails.
using PlayedRecording = std::function<Result<void>(const SampleSink&)>;

struct SimulatedPace {
  double speed = 1.0;      ///< seconds of the machine in a second
  std::uint64_t skip = 0;  ///< bytes that have been heard already: the same recording goes on behind them
};

inline constexpr double simulated_rate_hz = 100.0;  ///< a rest of half a second still has fifty samples

/// As text. The first call of what it gives begins the stream, which ends with the recording.
Result<Connect> played_source(PlayedRecording recording, const RawSetting& setting, const SimulatedPace& pace);

}  // namespace axiometry::app
