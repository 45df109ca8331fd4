// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/model/tracking.h"
#include "axiometry/tracking/length_difference.h"
#include "axiometry/tracking/squareness.h"
#include "axiometry/tracking/station.h"

/// From measured lengths to one test per line (Lee et al., 3.1; ISO 230-2 for x, y, z, ISO 230-6 for diagonals).
/// Derivation: docs/theory/line-evaluation.md.
///
/// With d(q) = |q + t − s| the nominal distance and ΔL the length shown, the deviation of position along the line is
/// x = ±(ΔL − d − c), + where the distance grows with position, c the dead path of the segment. c cancels from E and R
/// within one segment; it is chosen so that the first target's mean deviation is 0, or from the station location's
/// L0 where that is given.
namespace axiometry::tracking {

/// A place where the lengths jump by more than any machine does: the beam was broken and found again.
struct BeamBreak {
  std::string line;
  std::size_t before_reading = 0;  ///< in the order of measurement within the line
  double jump_mm = 0.0;
};

struct EvaluatedLine {
  std::string id;
  Test test;  ///< deviations along the line; metadata says the line, the tool and what is known of the station
  std::vector<double> distances_mm;              ///< nominal, of each target from the station
  OffsetUncertainty offset;                      ///< of the station across this line
  std::vector<Length> length_difference_bounds;  ///< 95 %, at each target, relative to the farthest
  double negligible_from_mm = 0.0;               ///< negligible_from_mm() for a third
  double slope_um_per_m = 0.0;                   ///< of the deviations along the line; kept, not removed
  double slope_uncertainty_um_per_m = 0.0;       ///< standard uncertainty, without the scale that lines share
  std::vector<BeamBreak> breaks;
};

struct LinesEvaluation {
  std::vector<EvaluatedLine> lines;
  std::optional<Squareness> squareness;  ///< absent where too few lines were measured
  std::vector<Finding> findings;
};

struct LineEvaluationOptions {
  Metadata metadata = {};                              ///< of all lines; axis and tracking are filled in per line
  std::optional<Matrix3> station_covariance_mm2 = {};  ///< in place of the plan's
  double break_threshold_mm = 0.05;                    ///< a jump above it is a break of the beam
  bool find_breaks = true;
};

/// Fails on readings of lines or targets that the plan does not have, on a reading given twice, on lengths that no
/// position within the travels explains (units, another plan), and on lines without enough readings for a Series.
Result<LinesEvaluation> evaluate_lines(const TrackingPlan& plan, std::span<const LengthReading> readings,
                                       const LineEvaluationOptions& options);

}  // namespace axiometry::tracking
