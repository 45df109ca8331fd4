// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/planned_points.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "axiometry/app/volumetric/part_stops.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

using volumetric::CalibrationPlan;
using volumetric::VolumetricLengths;

constexpr double steps_per_mm = 1000.0;  // of a coordinate in a program
constexpr std::size_t fewest_elsewhere = 3;

using PlaceKey = std::array<std::int64_t, 3>;
PlaceKey key_of(Vector3 at) {
  PlaceKey key{};
  for (std::size_t a = 0; a < 3; ++a) key[a] = std::llround(at[a] * steps_per_mm);
  return key;
}

/// Of one station with one tool.
struct Counts {
  std::size_t lengths = 0;
  std::size_t own = 0;                           // how many lie at points of their own part
  std::map<std::size_t, std::size_t> elsewhere;  // run and how many at points of it alone
};

}  // namespace

Result<std::vector<volumetric::VolumetricFinding>> check_planned(const CalibrationPlan& plan,
                                                                 const VolumetricLengths& lengths) {
  std::map<PlaceKey, std::vector<std::size_t>> runs_at;
  std::map<std::pair<std::string, std::string>, std::size_t> run_of;
  for (std::size_t run = 0; run < plan.runs.size(); ++run) {
    run_of[{plan.machine.stations[plan.runs[run].station].name, plan.machine.tools[plan.runs[run].tool].name}] = run;
    for (const volumetric::PlannedStop& stop : plan.runs[run].stops) {
      std::vector<std::size_t>& runs = runs_at[key_of(stop.axes_mm)];
      if (runs.empty() || runs.back() != run) runs.push_back(run);
    }
  }
  std::map<std::pair<std::size_t, std::size_t>, Counts> counts;
  for (const volumetric::VolumetricReading& r : lengths.readings) {
    Counts& c = counts[{r.station, r.tool}];
    ++c.lengths;
    const auto run = run_of.find({lengths.stations[r.station], lengths.tools[r.tool]});
    const auto at = runs_at.find(key_of(r.axes_mm));
    if (at == runs_at.end()) continue;
    const bool own = run != run_of.end() && std::ranges::find(at->second, run->second) != at->second.end();
    c.own += own ? 1 : 0;
    if (!own && at->second.size() == 1) ++c.elsewhere[at->second.front()];
  }
  std::vector<volumetric::VolumetricFinding> findings;
  for (const auto& [pair, c] : counts) {
    const std::string& station = lengths.stations[pair.first];
    const std::string& tool = lengths.tools[pair.second];
    for (const auto& [run, count] : c.elsewhere)
      if (count >= fewest_elsewhere && 2 * count >= c.lengths && count > c.own)
        return fail(fmt::format(
            "found {} of {} lengths of station {} with tool {} at the points of {}, expected them "
            "at those of their own part: station or tool are named wrongly",
            count, c.lengths, text::quoted(station), text::quoted(tool), part_text(plan, {run + 1, run + 1})));
    if (c.own < c.lengths)
      findings.push_back({"volumetric-not-planned", false,
                          fmt::format("{} of {} lengths of station {} with tool {} are at no point that the plan has "
                                      "for them",
                                      c.lengths - c.own, c.lengths, station, tool)});
  }
  return findings;
}

}  // namespace axiometry::app
