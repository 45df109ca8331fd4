// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/model/axis.h"
#include "axiometry/model/series.h"

/// The dead paths c of the stretches of a line between breaks of the beam. Model of a reading: ΔL − d = κ m(i, ±) + c,
/// with m(i, ±) the machine's deviation at target i from either direction, unknown and free, and c that of the stretch.
/// Least squares over all readings; derivation: docs/theory/line-evaluation.md.
namespace axiometry::tracking {

struct TiedSample {
  std::size_t target = 0;
  Direction direction = Direction::up;
  double excess_mm = 0.0;  ///< ΔL − d
  double cosine = 1.0;     ///< κ
  std::size_t stretch = 0;
  bool used = true;  ///< false: an outlier, which ties nothing
};

struct StretchFit {
  double shift_mm = 0.0;        ///< c less that of stretch 0
  double uncertainty_mm = 0.0;  ///< standard, from the scatter of the readings; 0 for stretch 0
  std::size_t ties = 0;  ///< readings at approaches (or, where not `by_approach`, targets) of another stretch too
  bool tied = true;      ///< whether it is tied to stretch 0, directly or by others
};

struct DeadPathFit {
  std::vector<StretchFit> stretches;
  /// Whether readings of the same target and direction tie. False: only targets reached from the other direction did,
  /// on the assumption that the reversal error is the same at all targets.
  bool by_approach = true;
  double scatter_mm = 0.0;  ///< standard deviation of a reading about the fit; 0 without redundancy
  std::size_t degrees_of_freedom = 0;
};

/// Where nothing ties a stretch its c is set so that the mean deviation does not jump between the nearest two targets
/// of both parts; `tied` is false then. Needs stretches numbered from 0 without gaps.
DeadPathFit fit_dead_paths(std::span<const TiedSample> samples, std::span<const Position> targets,
                           std::size_t stretches);

}  // namespace axiometry::tracking
