// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/part_stops.h"

#include <fmt/format.h>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/volumetric/plan/run_way.h"

namespace axiometry::app {

using volumetric::CalibrationPlan;
using volumetric::PlannedRun;

Result<PartRange> parse_part_range(std::string_view text) {
  const std::vector<std::string_view> ends = text::split(text, '-');
  const auto first = parse_count(text::trim(ends.front())), last = parse_count(text::trim(ends.back()));
  if (ends.size() > 2 || !first || !last || *first == 0 || *last < *first)
    return fail(
        fmt::format("found {}, expected the number of a part from 1, or the first and the last of several as "
                    "3-5",
                    text::quoted(text)));
  return PartRange{static_cast<std::size_t>(*first), static_cast<std::size_t>(*last)};
}

std::string part_text(const CalibrationPlan& plan, PartRange parts) {
  if (parts.first != parts.last) return fmt::format("parts {} to {}", parts.first, parts.last);
  const PlannedRun& run = plan.runs[parts.first - 1];
  return fmt::format("part {} (station {}, tool {})", parts.first, plan.machine.stations[run.station].name,
                     plan.machine.tools[run.tool].name);
}

Result<void> check_parts(const CalibrationPlan& plan, PartRange parts) {
  if (parts.first < 1 || parts.last < parts.first || parts.last > plan.runs.size())
    return fail(fmt::format("found part {} asked for, expected 1 to {}: a run for each station and tool",
                            parts.first < 1 ? parts.first : parts.last, plan.runs.size()));
  for (std::size_t part = parts.first; part <= parts.last; ++part)
    if (!plan.runs[part - 1].stops.empty()) return {};
  return fail(fmt::format("found no point in {}, expected at least one", part_text(plan, parts)));
}

PartStops part_stops(const CalibrationPlan& plan, PartRange parts) {
  AXIOMETRY_CONTRACT(check_parts(plan, parts).has_value());
  PartStops result;
  capture::StopList& list = result.list;
  list.drive.feed = plan.feed_mm_per_min;
  list.drive.dwell = plan.dwell;
  list.station_error_mm = planned_station_error_mm;
  const auto station_of = [&](std::size_t run) { return plan.machine.stations[plan.runs[run].station].at_mm; };
  capture::StopPath path(station_of(parts.first - 1), list.drive.turn_mm);
  for (std::size_t run = parts.first - 1; run < parts.last; ++run) {
    if (run >= parts.first) path.begin_segment(station_of(run));
    const Vector3 tool = plan.machine.tools[plan.runs[run].tool].offset_mm;
    std::size_t stop = 0;
    for (const volumetric::WayPoint& point : volumetric::way_of(plan, plan.runs[run])) {
      const Vector3 reflector = point.axes_mm + tool;
      if (!point.is_reading) {
        path.go(reflector);
        continue;
      }
      if (!point.beam_kept && stop > 0) path.begin_segment(station_of(run));
      path.stop(reflector);
      result.places.push_back({run, stop++});
    }
  }
  list.stops = path.stops();
  return result;
}

}  // namespace axiometry::app
