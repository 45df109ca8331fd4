// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/expected_stops.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"
#include "axiometry/model/aligned.h"

namespace axiometry::capture {
namespace {

constexpr double unsure_turn = 2.0;
constexpr double rough_station_mm = 5.0;
constexpr double located_station_mm = 1.0;
constexpr double machine_mm = 0.5;  // what a machine is off by, but for its scales

/// The point of the way a–b that is next to the station.
Vector3 foot_of(Vector3 station, Vector3 a, Vector3 b) {
  const Vector3 way = b - a;
  const double squares = dot(way, way);
  if (squares == 0.0) return a;
  return a + std::clamp(dot(station - a, way) / squares, 0.0, 1.0) * way;
}

double station_error_of(const Station& station) {
  if (!station.covariance_mm2) return rough_station_mm;
  const Matrix3& c = *station.covariance_mm2;
  return located_station_mm + 4.0 * std::sqrt(std::max(0.0, c[0][0] + c[1][1] + c[2][2]));
}

double interval_of(const Plan& plan) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < plan.targets.size(); ++i)
    smallest = std::min(smallest, plan.targets[i].in_native() - plan.targets[i - 1].in_native());
  return smallest;
}

}  // namespace

StandstillOptions standstill_options(const StopDrive& drive) {
  Plan plan;
  plan.feed = drive.feed;
  plan.dwell = drive.dwell;
  plan.overrun = Position::native(4.0 * drive.turn_mm);
  return standstill_options(plan);
}

StopPath::StopPath(Vector3 station_mm, double turn_mm)
    : station_(station_mm), turn_(turn_mm), eager_(turn_mm / unsure_turn), slow_(turn_mm * unsure_turn) {}

void StopPath::see(double distance_mm) {
  eager_.move_to(distance_mm);
  slow_.move_to(distance_mm);
  lowest_ = std::min(lowest_, distance_mm);
  highest_ = std::max(highest_, distance_mm);
}

void StopPath::go(Vector3 reflector_mm) {
  const double there = distance(reflector_mm, station_);
  if (!at_) lowest_ = highest_ = there;
  if (at_) see(distance(foot_of(station_, *at_, reflector_mm), station_));
  see(there);
  at_ = reflector_mm;
}

void StopPath::stop(Vector3 reflector_mm) {
  go(reflector_mm);
  ExpectedStop stop{reflector_mm, station_, {}, lowest_, highest_, segment_begins_, {}};
  if (eager_.direction() == slow_.direction()) stop.arrival = slow_.direction();
  stops_.push_back(stop);
  segment_begins_ = false;
  lowest_ = highest_ = stop.distance_mm();
}

void StopPath::begin_segment(Vector3 station_mm) {
  station_ = station_mm;
  at_.reset();
  eager_ = Travel(turn_ / unsure_turn);
  slow_ = Travel(turn_ * unsure_turn);
  segment_begins_ = true;
}

LineStops line_stops(const TrackingPlan& plan) {
  LineStops lines;
  StopList& list = lines.list;
  list.tolerance_mm = machine_mm;
  list.direction_counts = true;
  list.station_error_mm = is_aligned(plan.setup) ? 0.0 : station_error_of(plan.setup.station);
  double overrun = std::numeric_limits<double>::infinity(), dwell_s = overrun, feed = overrun;
  for (const TrackingLine& line : plan.lines) {
    overrun = std::min(overrun, line.plan.overrun.in_native());
    dwell_s = std::min(dwell_s, line.plan.dwell.in_s());
    feed = std::min(feed, line.plan.feed);
    list.tolerance_mm = std::min({list.tolerance_mm, interval_of(line.plan) / 4.0, overrun / 4.0});
  }
  if (plan.lines.empty()) return lines;
  list.drive = {feed, Duration::s(dwell_s), overrun / 4.0};
  const bool aligned = is_aligned(plan.setup);
  StopPath path(setup_along(plan.setup, plan.lines.front()).station.position_mm, list.drive.turn_mm);
  const Vector3 tool = plan.setup.tool_offset_mm;
  for (std::size_t k = 0; k < plan.lines.size(); ++k) {
    const Plan& of_line = plan.lines[k].plan;
    const auto line = spatial_line(of_line.axis);
    AXIOMETRY_CONTRACT(line.has_value());
    // An aligned interferometer sees nothing of the ways between, on which it is set up anew.
    if (aligned) path.begin_segment(setup_along(plan.setup, plan.lines[k]).station.position_mm);
    if (!aligned)
      for (const Vector3 place : of_line.way_in_mm) path.go(place + tool);
    for (const PlannedMove& move : moves(of_line)) {
      const Vector3 place = line->at(move.to) + tool;
      move.approach ? path.stop(place) : path.go(place);
      if (move.approach) lines.approaches.push_back({k, *move.approach});
    }
    if (!aligned)
      for (const Vector3 place : of_line.way_out_mm) path.go(place + tool);
  }
  list.stops = path.stops();
  return lines;
}

}  // namespace axiometry::capture
