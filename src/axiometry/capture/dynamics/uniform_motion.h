// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/capture/dynamics/motion_course.h"

/// Stretches in which an axis moves evenly, and what it does there. None of this is a parameter of ISO 230-2, which
/// needs an axis at rest at targets (5.3): nobody knows when the control wanted the axis where, so that only what is
/// left of a straight line of position over time can be told. An error of scale is not in it, nor a lag or a reversal.
namespace axiometry::capture {

/// Samples first … last, in one direction, whose smoothed velocity stays within a share of its median.
struct UniformStretch {
  std::size_t first = 0, last = 0;
  double velocity = 0.0;            ///< b of x = a + b t by least squares; negative on the way down, native per s
  double intercept = 0.0;           ///< a, at the first sample
  double velocity_deviation = 0.0;  ///< standard deviation of the smoothed velocity about its mean
  double velocity_range = 0.0;      ///< highest less lowest smoothed velocity
  double deviation_range = 0.0;     ///< range of the residuals, native
  double deviation_rms = 0.0;       ///< root mean square of the residuals, native
  double acceleration_rms = 0.0;    ///< native per s²

  std::size_t count() const { return last - first + 1; }
};

struct UniformOptions {
  double share = 0.05;  ///< share by which the velocity may leave its median
};

/// The longest stretch of every movement in one direction, in order of time, from where it first has its median
/// velocity to where it last has it, so that neither its start nor its braking counts. Left out are those shorter than
/// ten windows and movements no faster than ten times the noise of a velocity; how fast others are does not count,
/// since a rapid or a false sample says nothing of a feed.
std::vector<UniformStretch> uniform_stretches(const MotionRecord& record, const MotionCourse& course,
                                              const UniformOptions& options);

/// What is left of the straight line of a stretch at each of its samples, native.
std::vector<double> residuals_of(const MotionRecord& record, const UniformStretch& stretch);

/// The straight line through all samples, whatever they do: velocity and intercept alone are set.
UniformStretch whole_stretch(const MotionRecord& record);

}  // namespace axiometry::capture
