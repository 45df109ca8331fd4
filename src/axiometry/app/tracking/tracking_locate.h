// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/base/result.h"
#include "axiometry/tracking/station/location_points.h"
#include "axiometry/tracking/station/station.h"

/// The use cases "from measured points to the station of a tracking interferometer" and "which points to measure".
namespace axiometry::app {

struct LocateRequest {
  std::string file;  ///< CSV, formats/tracking/location_points_csv.h; "-" is the standard input
  tracking::StationOptions options;
  Vector3 tool_offset_mm;  ///< added to the coordinates of the file, where they are those of the axes
};

struct Located {
  LocateRequest request;
  std::string sha256;                 ///< hash of the file's bytes
  std::vector<LocationPoint> points;  ///< positions of the reflector by which the station was located
  tracking::StationLocation location;
};

/// Fails as the file, and as tracking::locate_station() does, with the file's name.
Result<Located> locate(const LocateRequest& request);

/// The same of bytes that are at hand; request.file only names them.
Result<Located> locate(const LocateRequest& request, std::string_view bytes);

/// Report and JSON.
Experiment present(const Located& located, const report::Options& options);

struct PlannedLocation {
  TrackingSetup setup;
  tracking::LocationPlan plan;
};

/// Fails as tracking::plan_location() does.
Result<PlannedLocation> plan_location_points(const TrackingSetup& setup, std::size_t count);

/// The sheet for the machine and JSON.
Experiment present(const PlannedLocation& planned, const report::Options& options);

/// The table to be filled in at the machine: where to drive the axes, where the reflector stands then, and an empty
/// column length_difference_mm. `axiometry tracking locate` reads it when it is full.
std::string location_points_csv(const PlannedLocation& planned);

/// Writes that table ("-" is the standard output). Fails rather than replace a table in which a length stands.
Result<void> write_location_points(const PlannedLocation& planned, const std::string& file);

}  // namespace axiometry::app
