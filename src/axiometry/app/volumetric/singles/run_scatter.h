// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// How far the runs of an error scatter, and so how well each mean of them is known.
namespace axiometry::app {

/// Over the runs of one direction at a position, µm or µrad.
struct DirectionMean {
  double mean = 0.0;
  std::optional<double> s;  ///< standard deviation; absent of one run
  std::size_t runs = 1;
};

struct PositionMeans {
  double at_mm = 0.0;
  std::optional<DirectionMean> up, down;  ///< one of them at least
};

/// Of one mean.
struct MeanScatter {
  double variance = 0.0;    ///< u², µm² or µrad²; 0 of one run, whose scatter nobody knows
  bool stands_out = false;  ///< by s of its own runs alone, which counts among no others
};

struct RunScatter {
  std::vector<std::array<MeanScatter, 2>> means;  ///< scatter of the means of each position, up and down
  /// s of the runs moving up and down, without means that stand out, where each direction has its own.
  std::optional<std::array<double, 2>> by_direction;
};

/// How often a mean of runs that scatter as all do, and an error with directions that do, counts by its own s all the
/// same. That costs little: such a mean has a larger u, and a direction fewer degrees of freedom.
inline constexpr double own_scatter_level = 0.01;

/// s is that of all means together, k/2 times as large where they tell it with so few degrees of freedom that k of
/// Student's t is more than 2: 2 u holds what k u would. Out of these are taken, the largest s first, means with runs
/// that do not scatter as the others do, up to half of them: as many as the last counts whose F over the rest chance
/// exceeds three times in a thousand errors (iso230_2::uneven_level; as generalised ESD has it of readings, so that two
/// do not hide each other). Each of them has its own s, with its own k. Of the others one has its own s, where that is
/// larger than what all have, if chance exceeds its F with own_scatter_level: one false reading of n is wrong in the
/// mean by just s/√n. Likewise each direction has an s of its own if chance exceeds the F of both, either way, so
/// often.
///
/// Where some runs agree to the last digit, readings have steps: no s² counts against less than the variance n s²/12 of
/// rounding to the least step that the other s tell.
RunScatter run_scatter(std::span<const PositionMeans> positions);

}  // namespace axiometry::app
