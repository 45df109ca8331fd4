// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/plan/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/go_on_unless.h"
#include "axiometry/base/text/text.h"
#include "axiometry/tracking/geometry/visibility.h"
#include "axiometry/volumetric/field/point_spread.h"
#include "axiometry/volumetric/field/unseen_reasons.h"
#include "axiometry/volumetric/identify/findings/findings.h"
#include "axiometry/volumetric/plan/point_set.h"

namespace axiometry::volumetric {
namespace {

constexpr std::size_t tries_per_point = 40;
constexpr std::size_t stations_wanted = 4;
constexpr std::size_t stops_least = 10;
constexpr double same_height_mm = 50.0;
constexpr double beside_mm = 120.0;  // a lever that a usual holder has
constexpr double longer_mm = 150.0;

bool is_visible(const TrackingSetup& setup, Vector3 axes_mm) {
  const Vector3 p = axes_mm + setup.tool_offset_mm;
  return !tracking::hidden_because(setup, p) && !tracking::blocked_because(setup, p, p);
}

std::vector<Vector3> offsets_of(const MachineModel& machine) {
  std::vector<Vector3> offsets;
  for (const Tool& tool : machine.tools) offsets.push_back(tool.offset_mm);
  return offsets;
}

std::string offset_text(Vector3 t) { return fmt::format("[{:.0f}, {:.0f}, {:.0f}]", t.x, t.y, t.z); }

void add_unseen(const Expectation& expected, std::vector<VolumetricFinding>& findings) {
  if (expected.unseen.empty()) return;
  std::string reasons;
  for (const std::string& reason : expected.reasons) reasons += "; " + reason;
  findings.push_back(
      {"volumetric-unseen-errors", true,
       fmt::format("these stations, tools and points will not tell {}{}", error_list(expected.unseen), reasons)});
}

void add_stations(const CalibrationPlan& plan, std::vector<VolumetricFinding>& findings) {
  const auto& stations = plan.machine.stations;
  if (stations.size() < stations_wanted)
    findings.push_back(
        {"volumetric-few-stations", false,
         fmt::format("{} station{} leave{} little to see a wrong one by; four or more are usual", stations.size(),
                     stations.size() == 1 ? "" : "s", stations.size() == 1 ? "s" : "")});
  const auto [low, high] = std::ranges::minmax(stations, {}, [](const NamedStation& s) { return s.at_mm.z; });
  if (stations.size() > 1 && high.at_mm.z - low.at_mm.z < same_height_mm)
    findings.push_back({"volumetric-one-height", false,
                        "all stations stand at nearly one height; one that stands higher or lower tells rotations "
                        "about the horizontal axes better"});
}

void add_stops(const CalibrationPlan& plan, std::size_t points, std::vector<VolumetricFinding>& findings) {
  std::size_t lost_ways = 0;
  for (const PlannedRun& run : plan.runs) {
    lost_ways += static_cast<std::size_t>(std::ranges::count(run.stops, false, &PlannedStop::beam_kept));
    if (run.stops.size() == points) continue;
    findings.push_back(
        {"volumetric-few-points", run.stops.size() < stops_least,
         fmt::format("from station {} only {} of {} points are in sight and in reach with tool {}: range, elevation, "
                     "incidence, the safe radius or an obstacle hides the others",
                     text::quoted(plan.machine.stations[run.station].name), run.stops.size(), points,
                     text::quoted(plan.machine.tools[run.tool].name))});
  }
  if (lost_ways > 0)
    findings.push_back({"volumetric-beam-lost", false,
                        fmt::format("on {} way{} between points the beam is lost and must be found again, which "
                                    "begins a segment",
                                    lost_ways, lost_ways == 1 ? "" : "s")});
}

std::vector<VolumetricFinding> findings_of(const PlannedCalibration& planned, std::size_t points) {
  std::vector<VolumetricFinding> findings;
  add_unseen(planned.expected, findings);
  if (const std::string advice = tool_advice(planned.plan.machine); !advice.empty())
    findings.push_back({"volumetric-add-tool", false, advice});
  if (const auto lever = short_lever(offsets_of(planned.plan.machine)))
    findings.push_back({"volumetric-short-lever", true, *lever});
  if (const auto small = detail::small_machine_finding(planned.plan.machine)) findings.push_back(*small);
  add_stations(planned.plan, findings);
  add_stops(planned.plan, points, findings);
  std::ranges::stable_partition(findings, &VolumetricFinding::serious);
  return findings;
}

}  // namespace

std::string tool_advice(const MachineModel& machine) {
  const std::vector<Vector3> offsets = offsets_of(machine);
  const Vector3 first = offsets.front();
  switch (tool_spread(offsets)) {
    case PointSpread::point:
      return fmt::format(
          "the tool points do not form a triangle: add a longer tool and one beside it, for example {} and {} mm",
          offset_text(first + Vector3{0, 0, -longer_mm}), offset_text(first + Vector3{beside_mm, 0, 0}));
    case PointSpread::line: {
      Vector3 along{}, middle{};
      for (const Vector3& t : offsets) {
        if (norm(t - first) > norm(along)) along = t - first;
        middle += 1.0 / static_cast<double>(offsets.size()) * t;
      }
      const Vector3 level = cross(along, {0.0, 0.0, 1.0});
      const Vector3 beside = norm(level) > 1e-3 * norm(along) ? unit(level) : Vector3{1.0, 0.0, 0.0};
      return fmt::format("the tool points stand on one line: add a tool beside it, for example {} mm",
                         offset_text(middle + beside_mm * beside));
    }
    case PointSpread::plane: return "";
  }
  return "";
}

std::vector<PlannedStop> plan_stops(const CalibrationPlan& plan, const PlannedRun& run, std::size_t points) {
  const TrackingSetup setup = setup_of(plan, run.station, run.tool);
  // Other places with each station and tool: multiples of the golden ratio are never near each other.
  constexpr double golden = 0.6180339887498949;
  const double turn = golden * static_cast<double>(run.station * plan.machine.tools.size() + run.tool);
  std::vector<Vector3> places;
  for (const Vector3& q :
       spread_points(plan.machine.travel, tries_per_point * points, {turn, 2.0 * turn, 3.0 * turn})) {
    if (places.size() == points) break;
    if (is_visible(setup, q)) places.push_back(q);
  }
  std::vector<PlannedStop> stops;
  for (const Vector3& q : short_tour(std::move(places))) {
    if (stops.empty()) {
      stops.push_back({q});
      continue;
    }
    auto way = tracking::safe_transfer(setup, stops.back().axes_mm, q);
    if (way) stops.push_back({q, std::move(way->over_mm), way->beam_kept});
  }
  return stops;
}

Result<PlannedCalibration> plan_calibration(CalibrationPlan plan, const PlanOptions& options) {
  constexpr std::size_t points_most = 2000, stations_most = 16;
  if (options.points < 1 || options.points > points_most)
    return fail(fmt::format("found {} points of each station and tool, expected 1 to {}", options.points, points_most));
  if (options.propose_stations) {
    if (options.stations < 1 || options.stations > stations_most)
      return fail(fmt::format("found {} stations, expected 1 to {}", options.stations, stations_most));
    AXIOMETRY_TRY(plan.machine.stations, propose_stations(plan, options));
  }
  if (plan.machine.stations.empty())
    return fail("found no station in the machine's file, expected stations_mm, or stations to be proposed");
  plan.runs.clear();
  for (std::size_t s = 0; s < plan.machine.stations.size(); ++s)
    for (std::size_t t = 0; t < plan.machine.tools.size(); ++t) {
      AXIOMETRY_TRY_VOID(go_on_unless(options.stop));
      PlannedRun run{s, t};
      run.stops = plan_stops(plan, run, options.points);
      plan.runs.push_back(std::move(run));
    }
  if (visits_of(plan).empty())
    return fail(
        "found no point that the instrument sees from any station, expected some: are the stations given in "
        "the machine's coordinates, and where does the reflector look?");
  AXIOMETRY_TRY_VOID(go_on_unless(options.stop));
  AXIOMETRY_TRY(Expectation expected, expect(plan.machine, visits_of(plan), options.expect));
  PlannedCalibration planned{std::move(plan), std::move(expected), {}};
  planned.findings = findings_of(planned, options.points);
  return planned;
}

Result<PlannedCalibration> judge_plan(CalibrationPlan plan) {
  AXIOMETRY_TRY(Expectation expected, expect(plan.machine, visits_of(plan), {}));
  std::size_t points = 0;
  for (const PlannedRun& run : plan.runs) points = std::max(points, run.stops.size());
  PlannedCalibration planned{std::move(plan), std::move(expected), {}};
  planned.findings = findings_of(planned, points);
  return planned;
}

}  // namespace axiometry::volumetric
