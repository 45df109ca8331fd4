// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/machine/volumetric_data.h"
#include "axiometry/volumetric/simulate/true_errors.h"

/// The lengths that a tracking interferometer would measure at a machine whose errors are known.
namespace axiometry::volumetric {

/// A reading to be taken: where the axes are told to stand, seen from which station, with which tool of the machine.
struct Visit {
  std::size_t station = 0;
  std::size_t tool = 0;
  Vector3 axes_mm;
};

/// As many for each station and tool, evenly over the travels (plan/point_set.h), other ones each time; station by
/// station, with each its tools in the order of the machine's file.
std::vector<Visit> spread_visits(const MachineModel& machine, std::size_t points, Draw draw);

/// The same with those of each station and tool in an order by chance. In their own order spread points step by a
/// constant share of each travel, modulo 1: every place is come to from one direction alone, and nothing tells
/// reversal from the common curve.
std::vector<Visit> in_any_order(std::vector<Visit> visits, Draw draw);

/// What is stated of a simulation; the rest is drawn.
struct SimulationChoices {
  const TrueErrors* errors = nullptr;  ///< else drawn of this size, with this reversal
  DrawnSize size = {};
  Reversal reversal = Reversal::none;
  std::span<const Visit> visits = {};  ///< else spread ones; in any order where there is reversal
  std::size_t points = 100;            ///< points of each station and tool, where they are spread
};

/// What a simulated machine does, but for faults and noise.
struct SimulatedCourse {
  TrueErrors errors;
  std::vector<Visit> visits;
};
SimulatedCourse simulated_course(const MachineModel& machine, const SimulationChoices& choices, Draw draw);

/// What goes wrong; 0 does not.
struct SimulatedFaults {
  bool noise = true;      ///< whether instrument and machine scatter as the machine's file states
  double drift_um = 0.0;  ///< standard deviation of what a dead path drifts from its first to its last reading
  double part_scale_um_per_m = 0.0;  ///< standard deviation of how much longer axes are at a station with a tool
  double share_of_station = 0.5;     ///< share of its variance that the tools of a station have in common
  std::size_t told_breaks = 0;       ///< breaks of the beam that begin a segment
  std::size_t untold_breaks = 0;     ///< which the file does not tell
  std::size_t lost = 0;              ///< readings that are not there
  std::size_t outliers = 0;          ///< readings that are wrong by 20 µm to 2 mm
};

struct SimulatedJump {
  std::size_t before_reading = 0;
  double jump_um = 0.0;
  bool told = false;
};
struct SimulatedOutlier {
  std::size_t reading = 0;
  double error_um = 0.0;
};
struct SimulatedDeadPath {
  std::size_t station = 0;
  std::size_t tool = 0;
  double dead_path_mm = 0.0;    ///< dead path at its first reading, before any break
  double drift_um = 0.0;        ///< drift of the lengths up to its last reading
  double scale_um_per_m = 0.0;  ///< how much longer axes are than the errors say
};

struct SimulatedLengths {
  VolumetricLengths lengths;
  std::vector<Vector3> displacements_um;  ///< where the tool point truly was at each reading, less where it should be
  std::vector<SimulatedDeadPath> dead_paths;
  std::vector<SimulatedJump> jumps;
  std::vector<SimulatedOutlier> outliers;
  std::vector<Visit> lost;
};

/// In which direction axes came to rest is told by the visit before, as identify() has it, lost ones included; before
/// the first move at a station with a tool an axis came moving up.
/// length = |(1 + scale) q + t + δ − s| − dead path + drift + jumps + noise, with δ by exact transformations
/// (kinematics.h), s the stations of the machine and σ after MachineModel::sigma_um(). Fails on no station, no visit, a
/// point within 1 mm of its station, and on more faults than a quarter of the readings.
Result<SimulatedLengths> simulate_lengths(const MachineModel& machine, const TrueErrors& errors,
                                          const std::vector<Visit>& visits, const SimulatedFaults& faults, Draw draw);

}  // namespace axiometry::volumetric
