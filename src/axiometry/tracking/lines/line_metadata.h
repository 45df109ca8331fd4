// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/model/tracking.h"
#include "axiometry/tracking/geometry/line_geometry.h"
#include "axiometry/tracking/station/length_difference.h"

/// What the plan and the set-up say about the test of a line. Private to tracking/.
namespace axiometry::tracking {

struct LineDescription {
  const TrackingLine& line;
  const TrackingSetup& setup;
  const LineGeometry& geometry;
  double travel_mm = 0.0;  ///< measured
  const Metadata& given;   ///< what the user gave for all lines
};

/// What the user gave, and from the plan: axis (its name is the id in capitals when it has none), cycle, feed, dwell,
/// tool offset, machine, place of the line and of the station. Where no calibration of the device is given,
/// U_CALIBRATION (A.1) is U = a + b·L of the instrument with L the measured travel: what it shows over a line is the
/// difference of two lengths, whose b·L differ by that of the travel.
Metadata line_metadata(const LineDescription& line);

/// What of it was not said by the user and enters the uncertainty.
std::vector<SourceRemark> line_remarks(const LineDescription& line);

}  // namespace axiometry::tracking
