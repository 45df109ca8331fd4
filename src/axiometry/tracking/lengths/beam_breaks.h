// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/model/axis.h"
#include "axiometry/model/series.h"

/// Where the lengths of a line jump although the machine does not: the beam was broken. Method and its limits:
/// docs/theory/line-evaluation.md.
namespace axiometry::tracking {

/// A reading of one line, in the order of measurement.
struct LineSample {
  std::size_t target = 0;
  Direction direction = Direction::up;
  double excess_mm = 0.0;   ///< σ(ΔL − d): the deviation along the line and the dead path together
  std::size_t segment = 0;  ///< as stated by the file
};

struct Jump {
  std::size_t before = 0;  ///< the sample that is the first after it
  double size_mm = 0.0;    ///< size of the excess
};

struct Jumps {
  std::vector<Jump> breaks;
  std::vector<Jump> outliers;  ///< single samples that lie apart from those before and behind them
  double threshold_mm = 0.0;
};

/// The step from one sample to the next is compared with what the machine does between these two targets in the other
/// runs and in the other direction (the median of these votes). Where fewer than two such steps are known, the nearest
/// of them and of what the machine's mean slope and reversal error make of it counts. The largest jump is taken first
/// and has no vote on the others. What is left above the threshold is a break where it stays, an outlier where the next
/// step takes it back but for less than the threshold. A first or last sample (also of a stated segment) that stands
/// alone is an outlier up to 1 mm, and behind a break where it is farther away. So neither reversal errors nor
/// positioning errors that repeat are breaks.
///
/// The threshold, when none is given, is the larger of 20 µm and 8 times the robust scatter of what is left; by the
/// mean slope alone, likewise from 50 µm. A step that nothing can be compared with (the only reversal) must exceed 1
/// mm. Time grows with the number of jumps (at most 1000) times that of the samples.
Jumps find_jumps(std::span<const LineSample> samples, std::span<const Position> targets,
                 std::optional<double> threshold_mm);

}  // namespace axiometry::tracking
