// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "axiometry/standards/iso230_2/scatter/outliers.h"

/// Parts of the scatter of a test, compared by F.
namespace axiometry::iso230_2::scatter {

/// Squares, and their degrees of freedom.
struct Sum {
  double squares = 0.0;
  double degrees = 0.0;
  double variance() const { return degrees > 0.0 ? squares / degrees : 0.0; }
};

inline Sum operator-(const Sum& a, const Sum& b) {
  return {std::max(0.0, a.squares - b.squares), a.degrees - b.degrees};
}

/// Tail of the ratio of a part's variance by that of the rest; 1 where one of them has no degrees of freedom, and where
/// it is surely above `level`.
double ratio_tail(const Sum& part, const Sum& rest, const Rounding& rounding, double level);

}  // namespace axiometry::iso230_2::scatter
