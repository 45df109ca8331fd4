// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/model/test.h"

namespace axiometry {

/// When each reading of a test was taken. What changes between its start and its end (temperatures, air, drift) is
/// interpolated along it.
struct TestCourse {
  /// 0 at the first reading, 1 at the last; dense as in Series::make_dense(), NaN for a direction or approach that is
  /// no part of the cycle.
  std::vector<double> share;
  std::optional<Duration> duration;  ///< time from the first reading to the last; absent when no times are known
  std::size_t steps = 0;             ///< steps from the first reading to the last, those that are missing counted
  std::string basis;                 ///< "the times of the readings", "readings equally far apart in the … cycle"
  /// Whether times or the cycle tell which reading came before which. Without, what depends on the order is not known:
  /// no drift is (drift.h).
  bool order_known = true;

  double at(const Series& series, std::size_t target, Direction direction, std::size_t run) const {
    return share[(static_cast<std::size_t>(direction) * series.target_count() + target) * series.run_count() + run];
  }
};

/// From Test::times_s when every reading has its time and they differ; else readings are taken to be equally far apart,
/// in the order of approaches() (model/plan.h) for the cycle of the metadata, where a missing reading keeps its time.
/// Where none is stated that is the standard one, and the basis says so.
/// Directions without readings are left out of the order. The order of a user-defined cycle is known to nobody, nor
/// that of a unidirectional one with readings in both directions: what is interpolated takes the standard one, and says
/// so. A unidirectional cycle with readings ↓ only goes from the last target to the first.
TestCourse course_of(const Test& test);

}  // namespace axiometry
