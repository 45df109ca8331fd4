// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/volumetric/identify/identifier.h"

/// Where an axis came to rest in one direction alone. Internal to identify().
namespace axiometry::volumetric::detail {

/// Positions at which an axis came to rest.
struct RestPlaces {
  std::vector<double> up_mm, down_mm;     ///< moving in that direction, in any order
  double lower_mm = 0.0, upper_mm = 0.0;  ///< range of its curves
};

struct OneSidedPlaces {
  double lowest_mm = 0.0, highest_mm = 0.0;  ///< places on the way that the other direction leaves out
  bool is_up = false;                        ///< they were reached moving up
};

/// Ways of more than `way_mm` without a place that was reached in one direction, and with some that were reached in the
/// other; rising, those reached moving up first.
std::vector<OneSidedPlaces> one_sided_places(RestPlaces places, double way_mm);

/// With curves of each direction: where the mean of both, and what they differ by, are what the curves make of readings
/// elsewhere. Curves may bend within each span, so half of one is how far readings of a direction tell of it.
void add_one_sided_places(const Identifier& done, const VolumetricLengths& lengths,
                          std::vector<VolumetricFinding>& findings);

}  // namespace axiometry::volumetric::detail
