// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "axiometry/model/series.h"

namespace axiometry::formats {

/// One approach as a file lists it, in any order.
struct Approach {
  Position target{};
  Direction direction = Direction::up;
  std::size_t run = 1;  ///< from 1
  Deviation deviation{};
  double time_s = std::numeric_limits<double>::quiet_NaN();  ///< since any epoch; NaN when not known
  TextPosition at{};
};

struct GatheredSeries {
  Series series;
  std::vector<double> times_s;  ///< as Test::times_s, from the first approach on; empty when no time is known
};

/// Puts every approach into its place, by its target and run. Targets within same_target are one. Fails, with the
/// place, on a reading given twice, on a run number beyond any test and as Series::make_dense() does.
Result<GatheredSeries> gathered(std::span<const Approach> approaches);

}  // namespace axiometry::formats
