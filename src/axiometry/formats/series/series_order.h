// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/model/series.h"

namespace axiometry::formats {

/// A series from targets in any order, as files list them: sorts them ascending and the readings with
/// them. `deviations` is dense as in Series::make_dense(), in the order of the given targets.
Result<Series> sorted_series(std::vector<Position> targets, std::size_t runs, std::vector<double> deviations);

/// Fails when every reading equals its target to a hundredth of the travel: measured positions in columns that claim
/// deviations.
Result<void> check_deviations(const Series& series, AxisKind kind);

struct Grid {
  std::size_t targets = 0;
  std::size_t runs = 0;
  std::size_t readings = 0;
};

/// Fails when the readings would fill but a fraction of the grid: a wrong run number, which must not claim
/// gigabytes.
Result<void> check_grid(const Grid& grid);

}  // namespace axiometry::formats
