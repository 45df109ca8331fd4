// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/caught_lengths.h"
#include "axiometry/base/unit_sizes.h"

namespace axiometry::app {

CaughtLengths caught_lengths(const capture::StopMatcher& matcher) {
  CaughtLengths caught;
  bool begins = false;
  for (const capture::StopMatch& match : matcher.matches()) {
    begins = begins || match.begins_segment;
    if (match.begins_segment && !match.planned) caught.broken_before.push_back(match.stop);
    const capture::Standstill& rest = matcher.standstills()[match.standstill];
    if (!matcher.gives_length(rest)) continue;
    caught.lengths.push_back({.stop = match.stop,
                              .length_mm = rest.position.in_native(),
                              .scatter_um = rest.spread.in_native() * um_per_mm,
                              .time_s = rest.begin_s,
                              .begins_segment = begins && !caught.lengths.empty()});
    begins = false;
  }
  return caught;
}

}  // namespace axiometry::app
