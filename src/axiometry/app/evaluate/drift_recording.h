// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/recording.h"
#include "axiometry/model/test.h"

/// A recording at standstill (A.2.5), as it goes with a test.
namespace axiometry::app {

/// Equally far apart, about their mean, in the native deviation unit.
struct DriftRecording {
  std::vector<double> values;
  Duration interval;
  std::string sha256{};  ///< hash of the file's bytes
};

/// Picks at most 2000 values, equally far apart, out of samples as they come, in memory that does not grow with them.
/// One sample is picked, not the mean of many: a reading of a test is no mean either.
class DriftPicker {
 public:
  Result<void> take(std::span<const Sample> samples);
  /// In the unit of the samples, at the median of their intervals or farther apart. Fails on fewer than 20 of them, and
  /// on a gap of more than ten such intervals: nobody knows what drifted in it.
  Result<DriftRecording> picked() const;

 private:
  std::vector<Sample> kept_;  ///< every stride-th
  std::size_t seen_ = 0;
  std::size_t stride_ = 1;
};

/// Any layout of a continuous recording (formats/recording.h) that tells its times. Fails as its reader does, with the
/// line, and on a range beyond 1 mm or 1°, which is no standstill or another unit than was taken.
Result<DriftRecording> read_drift_recording(const std::string& file, AxisKind kind);

/// Where the test has a recording, what it says of E_VE: the largest range over windows as long as the test. It takes
/// the place of a stated E_VE, unless that has the stronger origin, and then goes itself. Remarks tell of either, and
/// of a recording that says nothing: too short, without its interval, or of one value throughout.
Test with_recorded_variation(Test test);

}  // namespace axiometry::app
