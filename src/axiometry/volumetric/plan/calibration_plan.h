// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/model/tracking.h"
#include "axiometry/volumetric/machine/machine_model.h"
#include "axiometry/volumetric/simulate/simulated_lengths.h"

/// A volumetric calibration as it is to be measured: where the instrument stands in turn, and with each station and
/// tool the places at which a length is read.
namespace axiometry::volumetric {

struct PlannedStop {
  Vector3 axes_mm;
  std::vector<Vector3> over_mm = {};  ///< places to which the axes are driven before, in order, from the stop before
  bool beam_kept = true;              ///< whether the beam is kept on that way; else it must be found again

  friend bool operator==(const PlannedStop&, const PlannedStop&) = default;
};

/// With one station and one tool: one program.
struct PlannedRun {
  std::size_t station = 0;
  std::size_t tool = 0;
  std::vector<PlannedStop> stops = {};
};

struct CalibrationPlan {
  std::string date = {};
  MachineModel machine;  ///< the machine, with its stations
  TrackerLimits limits = {};
  std::vector<Obstacle> obstacles = {};
  double feed_mm_per_min = 3000.0;
  Duration dwell = Duration::s(3.0);
  std::vector<PlannedRun> runs = {};
};

/// All readings in order.
std::vector<Visit> visits_of(const CalibrationPlan& plan);

/// As the instrument sees the machine from one station with one tool.
TrackingSetup setup_of(const CalibrationPlan& plan, std::size_t station, std::size_t tool);

}  // namespace axiometry::volumetric
