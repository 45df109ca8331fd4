// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/model/series.h"

/// Runs with slopes of their own over the targets, such as those of an axis whose temperature changes between them.
namespace axiometry::iso230_2 {

/// How often a test of clean normal readings has such runs.
inline constexpr double tilt_level = 0.001;

/// A tilt is a slope times the range of the targets.
struct RunTilts {
  std::size_t run = 0;  ///< the one whose slope lies farthest from the others …
  Deviation tilt;       ///< … by this over the range of the targets
  Deviation between;    ///< standard deviation of the tilts, freed of what scatter does to them
  Deviation within;     ///< standard deviation of the readings about target, run and its slope
  double p = 1.0;       ///< probability that scatter alone makes such slopes
};

/// How far each target lies from the middle of all, as a part of their range: what a tilt of 1 adds there. 0 where all
/// are at one place.
std::vector<double> tilt_levers(const Series& series);

/// Of each run, of both directions' mean where both have it, in the native unit of deviations; NaN of a run without
/// three targets.
std::vector<double> run_tilts(const Series& series);

/// The series without the shifts and the slopes of its runs.
Series without_tilts(const Series& series);

}  // namespace axiometry::iso230_2
