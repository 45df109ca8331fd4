// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "axiometry/model/series.h"

/// Runs with slopes of their own over the targets, such as those of an axis whose temperature changes between them. A
/// tilt is a slope times the range of the targets, in the native unit of deviations. What ↑ and ↓ of a run have in
/// common counts, their mean; derivation in docs/theory/scatter.md.
namespace axiometry::iso230_2 {

/// How often a test of clean normal readings is said to have such runs.
inline constexpr double tilt_level = 0.001;

/// How often such a test is reckoned with them, where an interval rests on what the runs have of their own: less often,
/// and slopes would be missed that matter; more often, and intervals of clean tests would be too wide.
inline constexpr double tilt_counts_level = 0.05;

/// The tilts of a test, whether or not chance makes them.
struct TiltStudy {
  std::size_t runs = 0;          ///< that have a slope: three targets or more
  double variance = 0.0;         ///< of their tilts about the mean; 0 of fewer than two
  double of_scatter = 0.0;       ///< what scatter alone makes of that variance …
  double of_scatter_each = 0.0;  ///< … and of that of the tilts of one direction
  double in_readings = 0.0;      ///< variance of the readings by tilts that scatter does not make, on average
  double within = 0.0;           ///< standard deviation of the readings about target, run and slope
  double p = 1.0;                ///< chance that scatter alone makes tilts that differ so much; 1 of fewer than two …
  double p_of_each = 1.0;        ///< … and such of each direction, which may differ against each other
  std::array<std::optional<std::size_t>, 2> farthest;  ///< ↑ and ↓ of the run whose tilt lies farthest from the mean …
  double farthest_tilt = 0.0;                          ///< … and by how much

  double degrees() const { return static_cast<double>(runs) - 1.0; }
  /// Standard deviation of the tilts without what scatter makes of them.
  double between() const { return std::sqrt(std::max(0.0, variance - of_scatter)); }
  /// Standard uncertainty of the mean of all tilts, without what scatter makes of it; with degrees().
  double u_of_mean() const { return between() / std::sqrt(static_cast<double>(runs)); }
};

/// Of the readings as they were numbered; where ↑ and ↓ have runs of their own, the k-th of both are one.
TiltStudy tilt_study(const Series& series);

/// How far each target lies from the middle of all, as a part of their range: what a tilt of 1 adds there. 0 of one.
std::vector<double> tilt_levers(const Series& series);

/// Whether tilts, of both directions together or of each, are reckoned with.
inline bool counts(const TiltStudy& study) { return std::min(study.p, study.p_of_each) <= tilt_counts_level; }

/// Of each run ↑ and ↓; NaN of a run without three targets there.
std::array<std::vector<double>, 2> direction_tilts(const Series& series);

/// The series without the slopes of its runs, of each direction its own, about the middle of the targets that a run
/// has.
Series without_tilts(const Series& series);

}  // namespace axiometry::iso230_2
