// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/tracking/lengths/line_evaluation.h"

/// One line of evaluate_lines(). Private to tracking/.
namespace axiometry::tracking {

struct LineInput {
  const TrackingLine& line;
  const TrackingSetup& setup;               ///< set-up with the station's covariance that counts
  std::span<const LengthReading> readings;  ///< readings of this line at approaches of the plan, as they were measured
  std::span<const double> times_s;          ///< time of each reading, or empty
  const LineEvaluationOptions& options;
};

struct LineOutcome {
  EvaluatedLine line;
  Vector3 direction;  ///< direction in which position grows
  std::vector<Finding> findings;
};

/// Fails as line_geometry() does and with readings at fewer than two targets.
Result<LineOutcome> evaluate_line(const LineInput& input);

}  // namespace axiometry::tracking
