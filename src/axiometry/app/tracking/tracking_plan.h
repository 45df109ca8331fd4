// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/results/outputs.h"
#include "axiometry/app/tracking/tracking_locate.h"
#include "axiometry/app/tracking/tracking_text.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"
#include "axiometry/report/report.h"
#include "axiometry/tracking/lines/seven_lines.h"

/// The use case "from a station to a plan of lines".
namespace axiometry::app {

/// What the user says of the set-up, over that of a file where one is given.
struct SetupRequest {
  std::string file{};                    ///< a set-up or a tracking plan; empty for none
  std::optional<TrackingSetup> whole{};  ///< a set-up that is at hand, in place of a file
  std::optional<TravelBox> travel{};
  std::optional<Vector3> tool_offset_mm{};
  /// "x,y,z", the file of a located station, or "none" for an interferometer aligned with each line (model/aligned.h);
  /// empty: that of the file, or none where nothing but diagonals of the travels is asked for.
  std::string station{};
  std::optional<LowHigh> range_mm{};
  std::optional<LowHigh> elevation_deg{};
  std::optional<double> incidence_deg{};
  std::optional<Vector3> reflector_axis{};
  std::optional<double> safe_radius_mm{};
  std::optional<double> line_least_mm{};
  std::optional<RangingUncertainty> ranging{};
  std::vector<Obstacle> obstacles{};
};

/// The set-up, with the usual limits where nothing is said. Fails on travels or a station that nobody gave, on files as
/// their readers do, and as check_setup() does.
Result<TrackingSetup> setup_of(const SetupRequest& request);

struct TrackingPlanRequest {
  SetupRequest setup;
  tracking::LinesRequest lines;
  bool turn_reflector = false;  ///< so that the most lines are kept; without file and axis given it is turned, too
  bool suggest = false;         ///< say which station would be better
};

/// A set-up with the reflector mounted so that it sees the station best, where nobody said how it is mounted.
struct MountedSetup {
  TrackingSetup setup;
  std::vector<std::string> remarks;  ///< how it was turned
};

/// A place for the station that keeps more lines, or a longer shortest one.
struct BetterStation {
  tracking::StationSuggestion station;
  bool raised = false;  ///< not on the table as the station given is, but higher or lower
};

struct StationAdvice {
  tracking::StationSuggestion now;    ///< what the station given keeps
  std::vector<BetterStation> better;  ///< better stations, those on the table first; empty: none
  std::size_t lines = 0;              ///< how many of the seven lines were asked for
};

/// What a station elsewhere would keep; nothing to say of diagonals of the travels. Fails as setup_of() does.
Result<StationAdvice> advise_station(const TrackingPlanRequest& request);

/// What plan_tracking() plans on, so that points of the station location are seen by the same reflector. Fails as
/// setup_of() does.
Result<MountedSetup> mounted_setup(const TrackingPlanRequest& request);

struct PlannedLines {
  TrackingPlan plan;
  Duration duration;
};

/// The plan. Where the reflector may be turned, and where a station is to be suggested, remarks say what was found; the
/// error of a set-up in which no line is left says it as well.
Result<PlannedLines> plan_tracking(const TrackingPlanRequest& request);

/// The same of a plan that is at hand.
PlannedLines planned_lines(TrackingPlan plan);

/// The plan with duration and program, as its file holds it.
json::Value to_json(const PlannedLines& planned);

/// Points at which to locate the station of that set-up, its reflector turned as plan_tracking() would turn it, so that
/// one mounting serves both. Fails as setup_of() and tracking::plan_location() do.
Result<PlannedLocation> plan_location_points(const TrackingPlanRequest& request, std::size_t count);

/// A tracking plan from a file ("-" is the standard input). Fails with the file's name.
Result<TrackingPlan> read_tracking_plan_file(const std::string& file);

/// Whether a file holds one, and not a plan of one axis. Fails when it cannot be read.
Result<bool> is_tracking_plan_file(const std::string& file);

/// Writes the plan with program and duration to names.json, and its sheet to names.reports.
Result<void> write_outputs(const PlannedLines& planned, const OutputNames& names, const report::Options& options);

}  // namespace axiometry::app
