// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "axiometry/nc/axis_table.h"

/// Tables whose numbers are what is added from one position to the next, in whole counts.
namespace axiometry::nc::increments {

/// What a control takes of one number.
struct Range {
  long long lowest = 0, highest = 0;
  std::string_view unit = "";     ///< unit of a number, for messages: "times 2 µm"
  std::string_view way_out = "";  ///< what can be done about it: "a larger magnification or a shorter spacing"
};

/// From the position before to each but the first, in counts of `count` µm (″). What rounding leaves is carried, so
/// that the sum is right within half a count at every position; it is that from where the correction is 0. Fails on a
/// number out of range, naming the place.
Result<std::vector<long long>> of_curve(const std::vector<double>& positions, const std::vector<double>& values,
                                        double count, const Range& range);

}  // namespace axiometry::nc::increments
