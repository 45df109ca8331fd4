// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "axiometry/model/test.h"
#include "axiometry/standards/readings/test_course.h"

namespace axiometry {

/// A drift of the readings in time, as far as it is a straight line that all targets and directions share: what grows
/// from run to run. Derivation: docs/theory/reading-corrections.md.
struct Drift {
  Deviation over_test;                 ///< drift from the first reading to the last, b
  std::optional<Deviation> u;          ///< standard uncertainty of it; absent with fewer than three runs
  std::size_t degrees_of_freedom = 0;  ///< runs less two
  TestCourse course;

  /// In native units; per hour where times are known.
  std::optional<double> per_hour(Deviation over_whole_test) const;
  double per_reading(Deviation over_whole_test) const;
};

/// Least squares of x_ij = c_i + b τ_ij with a constant c_i per target and direction and the share τ of the course of
/// the test: b = Σ (τ − τ̄_i)(x − x̄_i)/Σ (τ − τ̄_i)², and u(b) from the scatter of the runs' means about their line,
/// since a run that lies elsewhere as a whole moves all its readings.
/// The constants keep what the machine does at its targets out of b; a machine that warms up is not told from an
/// instrument that drifts. Absent where no target has two readings from one direction (n = 1), and where nobody knows
/// their order (TestCourse::order_known).
std::optional<Drift> drift_of(const Test& test);

}  // namespace axiometry
