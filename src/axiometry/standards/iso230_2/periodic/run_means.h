// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/numeric/harmonic_fit.h"

/// What the search for a period and its fit are made from. Internal to periodic_error().
namespace axiometry::iso230_2 {

/// Means over the runs at the targets that have any; where readings are missing, of runs brought to one level.
struct RunMeans {
  std::vector<double> places;
  std::vector<double> values;
  std::size_t runs = 0;
  std::size_t missing = 0;        // of readings, in runs and at targets that have some
  std::optional<double> scatter;  // s/√n, pooled

  numeric::HarmonicData data() const { return {places, values}; }
  double travel() const { return places.back() - places.front(); }
  double spacing() const { return travel() / static_cast<double>(places.size() - 1); }
};

RunMeans run_means_of(const Series& series, Direction direction);

}  // namespace axiometry::iso230_2
