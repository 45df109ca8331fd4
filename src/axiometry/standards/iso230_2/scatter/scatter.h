// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"

/// Readings that do not scatter as one normal distribution would: outliers, targets that scatter more widely, runs that
/// shift as a whole or have slopes of their own. Found and told, never removed; derivation and error rates in
/// docs/theory/scatter.md.
///
/// x_ij = level of the target + shift of the run + slope of the run × place of the target + scatter, for each
/// direction. All tests are exact for normal scatter of a complete test but for Bonferroni's bound. Readings have a
/// step (what all of them are multiples of): no finding rests on less than what rounding to it explains. Cost: linear
/// in the readings.
namespace axiometry::iso230_2 {

/// How often a test of clean normal readings gets a finding of each kind, family-wise: with tilt_level in eleven of a
/// thousand.
inline constexpr double outlier_level = 0.004;
inline constexpr double uneven_level = 0.003;
inline constexpr double shift_level = 0.003;

/// A reading that the others of its target and its run do not let expect.
struct OutlyingReading {
  std::size_t target = 0;
  Direction direction = Direction::up;
  std::size_t run = 0;
  Deviation deviation;
  Deviation distance;  ///< distance from what the others let expect, signed
  double p = 1.0;      ///< probability that any reading of the test lies so far out by chance
};

/// Targets or a direction with a larger s_i (3.18) than the rest.
struct UnevenScatter {
  std::size_t first = 0;               ///< first target of those that scatter more
  std::size_t last = 0;                ///< last of these targets
  std::optional<Direction> direction;  ///< both when absent
  Deviation within;                    ///< root mean square of the s_i of these
  Deviation elsewhere;                 ///< scatter of the rest
  double p = 1.0;                      ///< probability that any part of the test stands out so by chance
};

/// Runs whose readings lie higher or lower as a whole.
struct RunShifts {
  bool ordered = false;  ///< a drift: they rise or fall from run to run
  Deviation drift;       ///< change from the first run to the last, of the straight line through their means
  std::size_t run = 0;   ///< the one that lies farthest from the others …
  Deviation shift;       ///< … by this from the mean of all
  Deviation between;     ///< standard deviation of the shifts, freed of what scatter does to means
  Deviation within;      ///< standard deviation of the readings about target and run
  double p = 1.0;        ///< probability that scatter alone makes such shifts
};

struct ScatterStudy {
  std::vector<OutlyingReading> outliers;  ///< readings in the order of direction, target, run
  std::optional<UnevenScatter> uneven;    ///< what stands out most
  std::optional<RunShifts> shifts;        ///< shifts where they make at least a third of s_i²
  std::optional<TiltStudy> tilts;         ///< slopes where they make at least a fifth of what is left of s_i²
};

/// What all readings are whole multiples of: 0.1, 0.02, 1. 0 where that is finer than 1e-4 or nothing.
double step_of(const Series& series);

/// `step`: that of the readings as they were taken; a correction hides it.
ScatterStudy scatter_study(const Series& series, double step);
inline ScatterStudy scatter_study(const Series& series) { return scatter_study(series, step_of(series)); }

/// The series without the shifts of its runs, for information: what R would be without them.
Series without_shifts(const Series& series);

}  // namespace axiometry::iso230_2
