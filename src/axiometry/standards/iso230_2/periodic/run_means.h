// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "axiometry/base/result.h"
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
  double u_means = 0.0;           // where readings are missing: what shifts of runs are uncertain by in the means, rms

  numeric::HarmonicData data() const { return {places, values}; }
  double travel() const { return places.back() - places.front(); }
  double spacing() const { return travel() / static_cast<double>(places.size() - 1); }
};

/// Fails where readings are missing and runs share too few targets to tell what they are shifted by, or are more than a
/// hundred.
Result<RunMeans> run_means_of(const Series& series, Direction direction);

}  // namespace axiometry::iso230_2
