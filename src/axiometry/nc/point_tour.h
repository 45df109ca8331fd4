// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/vector3.h"

/// Places in space that X, Y and Z are driven to in turn, to rest at some of them: a calibration with one station and
/// one tool.
namespace axiometry::nc {

struct TourStop {
  Vector3 at_mm;
  bool is_reading = true;  ///< else it is on the way, and nothing waits there
  bool find_beam = false;  ///< the operator finds the beam again there, before the reading
};

struct PointTour {
  std::vector<std::string> heading;  ///< comments before everything else
  std::vector<TourStop> stops;
  double feed_mm_per_min = 1000.0;
  Duration dwell;
};

}  // namespace axiometry::nc
