// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "axiometry/model/metadata.h"
#include "axiometry/standards/readings/test_course.h"

/// What a recording at standstill (A.2.5) says about the environment over the time of a test.
namespace axiometry {

struct RecordedEnvironment {
  double range = 0.0;          ///< largest over windows of the test's length, each beginning a quarter later: E_VE
  double length_s = 0.0;       ///< length of these windows
  double widest_from_s = 0.0;  ///< beginning of the window of that range, s after the first value
  std::size_t windows = 0;
  bool whole = false;  ///< the recording is no longer than the test, or the test's length is not known
  /// Standard deviation of what changes from one value to the next (half the mean square of the steps): white noise,
  /// and how the rest goes together, at equal lags from 0 to the length of the test.
  double white_sd = 0.0;
  std::vector<double> covariance;
};

/// Fewer values tell too little of how they go together.
inline constexpr std::size_t least_recorded_values = 20;

/// In the native deviation unit. Nothing where the metadata has no recording, or one of fewer values, or no interval.
std::optional<RecordedEnvironment> recorded_environment(const Metadata& metadata, const TestCourse& course);

/// A sinusoid of a whole number of periods over the recording.
struct RecordedSinusoid {
  double period_s = 0.0;
  double amplitude = 0.0;  ///< native; half its square is its part of the variance of the values
};

/// What the values are made of, from the longest period to the shortest, two steps (discrete Fourier transform about
/// the mean). Empty where recorded_environment() gives nothing. Of more than 4096 values only every second, third, … is
/// looked at, since time goes with the square of their number.
std::vector<RecordedSinusoid> recorded_spectrum(const Metadata& metadata);

}  // namespace axiometry
