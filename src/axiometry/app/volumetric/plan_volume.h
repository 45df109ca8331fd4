// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/volumetric/plan/planner.h"

/// The use case "where to stand and where to measure, and what that will tell".
namespace axiometry::app {

struct PlanVolumeRequest {
  std::string machine;  ///< JSON, formats/volumetric/machine_json.h
  /// Propose stations; absent: only where the machine's file has none.
  std::optional<bool> propose_stations = {};
  volumetric::PlanOptions options = {};
  TrackerLimits limits = {};
  std::vector<Obstacle> obstacles = {};
  std::optional<double> feed_mm_per_min = {};
  std::optional<Duration> dwell = {};
  std::string date = {};
};

/// Fails as the reader and the planner do, with the file's name. Remarks of the reader are findings.
Result<volumetric::PlannedCalibration> plan_volume(const PlanVolumeRequest& request);

/// Likewise where the machine is at hand; request.machine is only its name.
Result<volumetric::PlannedCalibration> plan_volume(formats::MachineFile machine, const PlanVolumeRequest& request);

/// {"stations", "runs", "rank", "unseen", "reasons", "errors" with the expected u, "volume", "findings"}: what is
/// expected.
json::Value expectation_value(const volumetric::PlannedCalibration& planned);

/// The points as a table, station,tool,x_mm,y_mm,z_mm, in the order of measurement; to be filled in at the machine,
/// with an empty column length_mm.
std::string planned_points_csv(const volumetric::CalibrationPlan& plan);

/// Whether a file holds such a plan. Fails when it cannot be read.
Result<bool> is_volumetric_plan_file(const std::string& file);

/// What a terminal shows.
std::string expectation_text(const volumetric::PlannedCalibration& planned);

}  // namespace axiometry::app
