// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/capture/stop_matcher.h"

namespace axiometry::app {

/// A length at a stop, as far as is known: a later standstill may show that one belongs elsewhere.
struct CaughtLength {
  std::size_t stop = 0;         ///< number within the part, from 0
  double length_mm = 0.0;       ///< as shown, mean over the rest
  double scatter_um = 0.0;      ///< standard deviation of its samples
  double time_s = 0.0;          ///< when it came to rest
  bool begins_segment = false;  ///< whether the dead path is another one than before

  friend bool operator==(const CaughtLength&, const CaughtLength&) = default;
};

struct CaughtLengths {
  std::vector<CaughtLength> lengths;
  std::vector<std::size_t> broken_before;  ///< stops before which the beam was broken though the plan keeps it
};

/// Of all rests that are taken for stops. One that gives no length may still be the first behind a break.
CaughtLengths caught_lengths(const capture::StopMatcher& matcher);

}  // namespace axiometry::app
