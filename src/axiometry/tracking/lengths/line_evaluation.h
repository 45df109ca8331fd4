// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/model/tracking.h"
#include "axiometry/tracking/lengths/squareness.h"
#include "axiometry/tracking/station/length_difference.h"
#include "axiometry/tracking/station/station.h"

/// From measured lengths to one test per line (Lee et al., 3.1; ISO 230-2 for x, y, z, ISO 230-6 for diagonals).
/// Derivation: docs/theory/line-evaluation.md.
///
/// With d(q) = |q + t − s| the nominal distance, ΔL the length shown and κ = ∂d/∂P (+1 or −1 on a line through the
/// station, + where the distance grows with position), the deviation of position along the line is
///   x = (ΔL − d − c)/κ,
/// c the dead path of the segment. Within one segment c cancels from every parameter of ISO 230-2 but M's sign and the
/// means shown; it is chosen so that the mean deviation at the first target is 0. Segments of one line are tied by
/// targets that both have, by least squares over all readings of the line. Nothing else is fitted or removed: the slope
/// of the line stays.
namespace axiometry::tracking {

/// A place where the lengths jump by more than any machine does: the beam was broken and found again.
struct BeamBreak {
  std::string line;
  std::size_t before_reading = 0;  ///< number of the reading in the order of measurement within the line, from 0
  double jump_mm = 0.0;            ///< jump of the length shown, against the nominal one
};

/// A stretch of readings with one dead path c, between two breaks of the beam (found or stated by the file).
struct DeadPath {
  std::size_t first_reading = 0;  ///< number of the reading in the order of measurement within the line, from 0
  std::size_t readings = 0;
  double dead_path_mm = 0.0;    ///< c: what the instrument shows less the nominal distance
  double uncertainty_mm = 0.0;  ///< standard, of c relative to that of the line's first stretch; 0 for that one
  std::size_t ties = 0;         ///< readings at approaches (or targets) that another stretch has too
  bool tied = true;             ///< false: no reading ties it to the first one, c rests on the assumption of no step
};

struct EvaluatedLine {
  std::string id;
  Test test;  ///< deviations along the line; metadata says the line, the tool and what is known of the station
  /// Nominal, of each target of the test from the station; from the beginning of the line where there is none.
  std::vector<double> distances_mm;
  OffsetUncertainty offset;                      ///< that of the station across this line; 0 when nothing is known
  std::vector<Length> length_difference_bounds;  ///< 95 %, at each target, relative to the farthest; else empty
  double negligible_from_mm = 0.0;               ///< negligible_from_mm() for a third; 0 when nothing is known
  double slope_um_per_m = 0.0;                   ///< slope of the deviations along the line; kept, not removed
  double slope_uncertainty_um_per_m = 0.0;       ///< standard uncertainty, without the scale that lines share
  double beam_angle_most_deg = 0.0;              ///< largest angle of beam and line: 0 on a line through the station
  std::vector<BeamBreak> breaks;                 ///< those found in the lengths, not those stated
  std::vector<DeadPath> dead_paths;              ///< one or more, in the order of measurement
  double slope_degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< that the slope's u is known with
};

struct LinesEvaluation {
  std::vector<EvaluatedLine> lines;  ///< x, y, z, xy, xz, yz, xyz, then others as they were driven      ///< in the
                                     ///< order of the plan; lines without readings are left out
  std::optional<ScalesAndSquareness> squareness;  ///< absent where too few lines were measured
  std::vector<Finding> findings;
};

struct LineEvaluationOptions {
  Metadata metadata = {};                              ///< metadata of all lines, but for axis and tracking
  std::optional<Matrix3> station_covariance_mm2 = {};  ///< covariance that takes the place of the plan's
  std::optional<double> break_threshold_mm = {};       ///< a jump above it is a break; else from the scatter
  bool find_breaks = true;                             ///< else only the stated segments part the lengths
  bool reversed = false;                               ///< the instrument counts down when the reflector recedes
  bool in_program_order = false;                       ///< readings were assigned by their order alone
  std::vector<double> times_s = {};                    ///< time of each reading, s; NaN where not known, or empty
};

/// `readings` stand in the order of measurement. Fails on a plan that is not sound, on readings of lines or targets
/// that the plan does not have, on a reading given twice, a length that is not finite or beyond 1e6 mm, on lengths that
/// fall where they must grow, that no position within the travels explains (units, another plan) or that fit other
/// approaches than theirs (reading_order.h), on lines that run past the station, and on lines with readings at fewer
/// than two targets.
Result<LinesEvaluation> evaluate_lines(const TrackingPlan& plan, std::span<const LengthReading> readings,
                                       const LineEvaluationOptions& options);

}  // namespace axiometry::tracking
