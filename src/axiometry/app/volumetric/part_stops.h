// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/capture/expected_stops.h"
#include "axiometry/volumetric/plan/calibration_plan.h"

/// What the parts of a volumetric plan make the reflector do, as a tracking interferometer sees it.
namespace axiometry::app {

/// Parts of a plan that are measured one after another, from 1; a part is a run, one station with one tool.
struct PartRange {
  std::size_t first = 1;
  std::size_t last = 1;

  friend bool operator==(const PartRange&, const PartRange&) = default;
};

/// "3", or "3-5" of several. Fails on other texts and on a last that is before the first.
Result<PartRange> parse_part_range(std::string_view text);

/// "part 3 (station A, tool short)", "parts 3 to 5".
std::string part_text(const volumetric::CalibrationPlan& plan, PartRange parts);

/// Fails on parts that the plan does not have, and where they have no stop.
Result<void> check_parts(const volumetric::CalibrationPlan& plan, PartRange parts);

/// How far the instrument may stand from its planned place, until something better is known.
inline constexpr double planned_station_error_mm = 20.0;

/// Where a stop stands in the plan.
struct PartStop {
  std::size_t run = 0;
  std::size_t stop = 0;  ///< number within the run, from 0
};

struct PartStops {
  capture::StopList list;
  std::vector<PartStop> places;  ///< where each stop of `list` stands in the plan
};

/// The ways of the programs (volumetric/plan/run_way.h). A segment begins with each part, and where the plan expects
/// that the beam is lost. Needs parts of the plan (contract).
PartStops part_stops(const volumetric::CalibrationPlan& plan, PartRange parts);

}  // namespace axiometry::app
