// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "axiometry/model/tracking.h"

/// An interferometer that is aligned with each line in turn, as ISO 230-6 has it for diagonals: it follows nothing and
/// has no station. A set-up says so by a station that is no place: its coordinates are not numbers, which no file and
/// no flag can give.
namespace axiometry {

inline Station no_station() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {{none, none, none}, {}};
}

inline bool is_aligned(const TrackingSetup& setup) { return std::isnan(setup.station.position_mm.x); }

/// As one line of that plan is seen: where the interferometer is aligned, from a place on the extension of the line, a
/// metre before its first target. Where on it does not matter: the dead path takes it up, and the beam lies in the
/// line. Another set-up, and a line that is not stated in space, as they are.
inline TrackingSetup setup_along(TrackingSetup setup, const TrackingLine& line) {
  constexpr double before_mm = 1000.0;
  const auto way = spatial_line(line.plan.axis);
  if (!is_aligned(setup) || !way || line.plan.targets.empty()) return setup;
  setup.station.position_mm =
      way->at(line.plan.targets.front()) + setup.tool_offset_mm - before_mm * way->direction + Vector3{};
  return setup;
}

}  // namespace axiometry
