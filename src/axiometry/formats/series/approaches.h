// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/model/test.h"

namespace axiometry::formats {

/// One reading as a file lists it, with the approach that it was taken in; in any order.
struct ListedReading {
  Position target{};
  Direction direction = Direction::up;
  std::size_t run = 1;  ///< number of the run, from 1
  Deviation deviation{};
  double time_s = std::numeric_limits<double>::quiet_NaN();  ///< time since any epoch; NaN when not known
  TextPosition at{};
};

struct GatheredSeries {
  Series series;
  std::vector<double> times_s;           ///< as Test::times_s, from the first approach on; empty when no time is known
  std::optional<SourceRemark> remark{};  ///< why known times were left out
};

/// Puts every approach into its place, by its target and run. Targets within same_target are one. Times that run
/// backwards from one run to the next at a target, or to and fro within a run, which none of the cycles makes them do,
/// are left out: a clock was set, or midnight passed. Fails, with the place, on a reading given twice, on a run number
/// beyond any test and as Series::make_dense() does.
Result<GatheredSeries> gathered(std::span<const ListedReading> approaches);

}  // namespace axiometry::formats
