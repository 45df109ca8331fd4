// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

#include "axiometry/base/result.h"

/// What an instrument says when it is asked all the time: positions by time, before anybody knows which of them belong
/// to targets (capture/ finds that out).
namespace axiometry {

/// One sample of a continuous recording. Plain numbers, because there are hundreds of millions of them.
struct Sample {
  double time_s = 0.0;    ///< seconds since some beginning of the recording
  double position = 0.0;  ///< as the instrument shows it: mm or °, after the kind of the axis
};

/// Farther there is no sample: sums of the squares of as many as there may be stay finite.
inline constexpr double farthest_sample = 1e15;

/// Whether time and position are numbers, and none lies farther.
inline bool is_sound(const Sample& sample) {
  return std::abs(sample.time_s) <= farthest_sample && std::abs(sample.position) <= farthest_sample;
}

/// Takes samples in the order of the recording, some at a time.
using SampleSink = std::function<Result<void>(std::span<const Sample>)>;

}  // namespace axiometry
