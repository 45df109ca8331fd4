// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/plan/calibration_plan.h"
#include "axiometry/volumetric/plan/expectation.h"

/// Proposes stations and points of a volumetric calibration, and says what they will tell.
namespace axiometry::volumetric {

struct PlanOptions {
  bool propose_stations = true;        ///< otherwise the machine's own stations are taken
  std::size_t stations = 4;            ///< how many stations are proposed
  std::optional<TravelBox> room = {};  ///< room where the instrument may stand; station_room() when absent
  std::size_t points = 100;            ///< points of each station and tool
  ExpectOptions expect = {};
  std::stop_token stop = {};  ///< nobody waits for it any more: fails, as unavailable
};

/// Where an instrument is looked for when nothing else is said: over the table as far as reflectors reach and 15 % of
/// that beyond at each side; its centre about as high as the lowest reflector, up to a quarter of the travel of Z below
/// or above.
TravelBox station_room(const MachineModel& machine);

/// Of places on a grid over the room (5 × 4 × 3) those from which the tool point's error comes out best (the mean of
/// its variance, of few points with curves of degree 3), by exchange of one at a time; at two heights at least, 200 mm
/// apart, and each with a quarter of the points in sight with each tool. Fails when fewer places than stations see so
/// much, saying what hides the points most often.
Result<std::vector<NamedStation>> propose_stations(const CalibrationPlan& plan, const PlanOptions& options);

/// Places of the station and tool that the reflector may reach and the instrument sees, evenly over the travels, in a
/// short tour on ways on which nothing is touched. Fewer than asked for when of forty times as many no more are
/// visible.
std::vector<PlannedStop> plan_stops(const CalibrationPlan& plan, const PlannedRun& run, std::size_t points);

struct PlannedCalibration {
  CalibrationPlan plan;
  Expectation expected;
  std::vector<VolumetricFinding> findings;  ///< serious ones first
};

/// `plan` says machine, limits, obstacles, feed and dwell. Fails on no points, fewer than 1 station, stations that
/// cannot be proposed or see nothing, and as expect() does. Errors that will not be told are a serious finding.
Result<PlannedCalibration> plan_calibration(CalibrationPlan plan, const PlanOptions& options);

/// What a plan will tell as it is, with its findings; stops that a run has less than the largest one count as hidden.
/// Fails as expect() does.
Result<PlannedCalibration> judge_plan(CalibrationPlan plan);

/// Which tools to add so that the tool points form a triangle; "" when they do.
std::string tool_advice(const MachineModel& machine);

}  // namespace axiometry::volumetric
