// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/base/result.h"

/// Velocity and acceleration of an axis from positions at equal intervals of time.
///
/// At each sample a parabola is fitted to the 2h + 1 samples about it (Savitzky & Golay, Analytical Chemistry 36, 1964,
/// 1627): with j = −h … h, S_2 = Σ j², S_4 = Σ j⁴, n = 2h + 1 and the interval τ,
///   v = Σ j x_j / (S_2 τ),   a = 2 Σ (j² − S_2/n) x_j / ((S_4 − S_2²/n) τ²).
/// A motion of constant acceleration is met exactly. A vibration within the window is averaged: of its velocity is left
/// the share 3 (sin z − z cos z)/z³ with z = π f T, T the time of the window: 90 % at f = 0.32/T, 50 % at 0.79/T.
namespace axiometry::capture {

/// Positions at equal intervals, in the native unit of the axis (mm or °).
struct MotionRecord {
  double rate_hz = 0.0;
  double begin_s = 0.0;  ///< time of the first sample
  std::vector<double> positions;

  double time_s(std::size_t k) const { return begin_s + static_cast<double>(k) / rate_hz; }
  double duration_s() const { return static_cast<double>(positions.size()) / rate_hz; }
};

/// The first and the last h samples have the parabola of the first and the last window.
struct MotionCourse {
  std::size_t half_window = 0;       ///< h
  double window_s = 0.0;             ///< T = (2h + 1) τ
  std::vector<double> velocity;      ///< native units per s
  std::vector<double> acceleration;  ///< native units per s²
  double noise = 0.0;                ///< standard deviation of a position, from third differences (median), native;
                                     ///< that of rounding to steps, q/√12, where more is not seen
  double resolution = 0.0;           ///< q then; else 0
  double velocity_noise = 0.0;       ///< what that makes of a velocity: noise/(√S_2 τ)
  double acceleration_noise = 0.0;   ///< noise of an acceleration: 2 noise/(√(S_4 − S_2²/n) τ²)
};

/// Fails on a window shorter than 5 samples or longer than a quarter of the record.
Result<MotionCourse> motion_course(const MotionRecord& record, double window_s);

/// 10 ms, and so that it can be kept: five samples at least, a quarter of the record at most.
double usual_window_s(const MotionRecord& record);

}  // namespace axiometry::capture
