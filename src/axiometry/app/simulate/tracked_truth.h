// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/app/simulate/tracked_simulation.h"
#include "axiometry/base/json/json.h"

namespace axiometry::app {

/// What a simulation made, as far as it was asked for.
struct TrackedResults {
  simulation::VirtualTracker tracker;  ///< tracker with its station
  std::optional<simulation::SimulatedLocation> location;
  std::optional<TrackingPlan> plan;
  std::optional<simulation::SimulatedLineLengths> lengths;
  std::vector<Vector3> range_points_mm;
  std::vector<Vector3> stations_mm;
  std::optional<simulation::SimulatedRanges> ranges;
};

/// The errors that were put in, and where the reflector truly was at each reading. docs/howto/simulate-tracking.md.
json::Value tracked_truth_value(const TrackedSimulation& request, const TrackedResults& results);

/// The tables that the other verbs of `axiometry tracking` read; each says that it is no measurement.
std::string location_table(const TrackedSimulation& request, const simulation::SimulatedLocation& location);
std::string length_table(const TrackedSimulation& request, const simulation::SimulatedLineLengths& lengths);
std::string range_table(const TrackedSimulation& request, const TrackedResults& results);

}  // namespace axiometry::app
