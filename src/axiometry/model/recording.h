// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// Takes samples in the order of the recording, some at a time.
using SampleSink = std::function<Result<void>(std::span<const Sample>)>;

}  // namespace axiometry
