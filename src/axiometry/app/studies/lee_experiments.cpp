// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/studies/lee_experiments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/tracking/line_slopes.h"
#include "axiometry/base/counted.h"

namespace axiometry::app::lee {
namespace {

using simulation::TrackedMachine;
using simulation::VirtualTracker;

/// Rows do not share their noise.
std::uint64_t seed_of(std::uint64_t seed, std::size_t row) { return seed * 100 + row; }

VirtualTracker tracker_of(const Set& set) { return {.station_mm = set.station_mm, .noise = set.noise}; }

/// Drives to the points with the machine's errors and locates the station from where they should have been.
Result<BothEstimates> locate(const Set& set, const TrackedMachine& machine, std::size_t row) {
  AXIOMETRY_TRY(const auto simulated,
                simulation::simulate_location(machine, tracker_of(set), set.points_mm, {}, seed_of(set.seed, row)));
  // All lengths weigh the same, as in the paper. What is stated has no other use here; it must be more than 0.
  tracking::StationOptions options{.ranging = {Length::nm(std::max(2.0 * set.noise.in_nm(), 1.0)), {}}};
  options.near_mm = set.station_mm;
  AXIOMETRY_TRY(const auto location, tracking::locate_station(simulated.points, options));
  if (!location.linear || location.linear->rank < 5)
    return fail(fmt::format("found points on a {}, expected six from which eq. 14 has one solution",
                            tracking::critical_surface_name(location.surface)));
  BothEstimates found{location.linear->station_mm, location.refined.station_mm, 0.0};
  for (const double r : location.refined.residuals_mm)
    found.largest_residual_mm = std::max(found.largest_residual_mm, std::abs(r));
  return found;
}

double largest(Vector3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

Shift shift_of(std::string_view name, Vector3 printed_mm, const BothEstimates& found, const BothEstimates& baseline) {
  return {std::string(name), printed_mm, found.linear_mm - baseline.linear_mm, found.refined_mm - baseline.refined_mm,
          found.largest_residual_mm};
}

/// What the rows say about a response: that of −e against that of +e, of two axes against each alone.
void judge(ProportionalError& result) {
  // Rows 0 to 5 are x, y, z with + and −; rows 6 to 11 pair x and y, x and z, y and z.
  constexpr std::size_t first[] = {0, 0, 2}, second[] = {2, 4, 4};
  double squares = 0.0;
  for (std::size_t k = 0; k < row_count; ++k) {
    const Vector3 departure = result.shown_mm(k) - table3_corrected_mm(k);
    squares += dot(departure, departure);
    result.largest_mm = std::max(result.largest_mm, largest(departure));
    result.estimators_apart_mm =
        std::max(result.estimators_apart_mm, norm(result.shifts[k].refined_mm - result.shifts[k].linear_mm));
  }
  result.rms_mm = std::sqrt(squares / (3.0 * row_count));
  result.misprinted_mm = result.shown_mm(misprinted_row).z;
  for (std::size_t k = 0; k < row_count; k += 2)
    result.oddness_mm = std::max(result.oddness_mm, largest(result.shown_mm(k) + result.shown_mm(k + 1)));
  for (std::size_t pair = 0; pair < 3; ++pair)
    for (std::size_t sign = 0; sign < 2; ++sign)
      result.additivity_mm = std::max(
          result.additivity_mm, largest(result.shown_mm(6 + 2 * pair + sign) - result.shown_mm(first[pair] + sign) -
                                        result.shown_mm(second[pair] + sign)));
}

constexpr std::pair<std::string_view, Vector3> seven[] = {{"x", {1, 0, 0}},  {"y", {0, 1, 0}},  {"z", {0, 0, 1}},
                                                          {"xy", {1, 1, 0}}, {"xz", {1, 0, 1}}, {"yz", {0, 1, 1}},
                                                          {"xyz", {1, 1, 1}}};

/// Lines from the station as it was located; a line of one axis counts its positions as that axis does.
TrackingPlan plan_of(Vector3 station_mm, const std::vector<double>& distances_mm) {
  TrackingPlan plan;
  plan.setup.station.position_mm = station_mm;
  plan.setup.travel = {{-1e4, -1e4, -1e4}, {1e4, 1e4, 1e4}};
  for (const auto& [id, way] : seven) {
    TrackingLine line{.id = std::string(id), .plan = {}};
    const Vector3 direction = unit(way);
    const double at = id.size() == 1 ? dot(station_mm, direction) : 0.0;
    line.plan.axis.name = line.id;
    set_spatial_line(line.plan.axis, {station_mm - at * direction, direction});
    for (const double d : distances_mm) line.plan.targets.push_back(Position::native(at + d));
    line.plan.overrun = Position::native(2.0);
    line.plan.feed = 3000.0;
    plan.lines.push_back(std::move(line));
  }
  return plan;
}

Result<std::vector<double>> line_slopes(const SlopeRequest& request, const TrackedMachine& machine, Vector3 station_mm,
                                        std::size_t row) {
  const TrackingPlan plan = plan_of(station_mm, request.distances_mm);
  AXIOMETRY_TRY(const auto lengths, simulation::simulate_lengths(machine, tracker_of(request.set), plan, {},
                                                                 seed_of(request.set.seed, row)));
  return slopes_um_per_m(plan, lengths.readings);
}

}  // namespace

Result<CoordinateOffset> coordinate_offset(const Set& set, double offset_mm) {
  CoordinateOffset result{.set = set, .offset_mm = offset_mm, .baseline = {}, .shifts = {}};
  AXIOMETRY_TRY(result.baseline, locate(set, {}, 0));
  for (std::size_t k = 0; k < row_count; ++k) {
    const Row& row = rows()[k];
    TrackedMachine machine;
    machine.offset_mm = offset_mm * row.given;
    AXIOMETRY_TRY(const BothEstimates found, locate(set, machine, k + 1));
    const Shift& shift = result.shifts.emplace_back(shift_of(row.name, row.table2_mm, found, result.baseline));
    result.worst_linear_mm = std::max(result.worst_linear_mm, largest(shift.linear_mm + machine.offset_mm));
    result.worst_refined_mm = std::max(result.worst_refined_mm, largest(shift.refined_mm + machine.offset_mm));
    result.worst_printed_mm = std::max(result.worst_printed_mm, largest(row.table2_mm + row.given));
  }
  return result;
}

Result<ProportionalError> proportional_error(const Fixture& fixture, Length noise, std::uint64_t seed) {
  const Set set{.station_mm = fixture.station_mm, .points_mm = fixture.points_mm, .noise = noise, .seed = seed};
  ProportionalError result{.fixture = fixture, .shifts = {}};
  AXIOMETRY_TRY(const BothEstimates baseline, locate(set, {}, 0));
  for (std::size_t k = 0; k < row_count; ++k) {
    const Row& row = rows()[k];
    TrackedMachine machine;
    machine.origin_mm = fixture.origin_mm;
    for (std::size_t a = 0; a < 3; ++a) machine.scale[a] = RelativeLength::um_per_m(fixture.error * row.given[a] * 1e6);
    AXIOMETRY_TRY(const BothEstimates found, locate(set, machine, k + 1));
    result.shifts.push_back(shift_of(row.name, row.table3_mm, found, baseline));
  }
  judge(result);
  return result;
}

Result<Slopes> slopes(const SlopeRequest& request) {
  if (request.distances_mm.size() < 2)
    return fail(fmt::format("found {}, expected at least two", counted(request.distances_mm.size(), "distance")));
  Slopes result{.request = request, .before = {}, .after = {}, .lines = {}};
  const double base = request.base.in_um_per_m() * 1e-6, added = request.added.in_um_per_m() * 1e-6;
  const double change = base + added + base * added - base;  // (1 + base)(1 + added) = 1 + base + change
  TrackedMachine machine;
  machine.origin_mm = request.origin_mm;
  machine.scale[request.axis] = request.base;
  AXIOMETRY_TRY(result.before, locate(request.set, machine, 0));
  AXIOMETRY_TRY(const auto before, line_slopes(request, machine, result.before.refined_mm, 1));
  machine.scale[request.axis] = RelativeLength::um_per_m((base + change) * 1e6);
  machine.offset_mm = request.offset_mm;
  AXIOMETRY_TRY(result.after, locate(request.set, machine, 2));
  AXIOMETRY_TRY(const auto after, line_slopes(request, machine, result.after.refined_mm, 3));
  for (std::size_t k = 0; k < std::size(seven); ++k) {
    const Vector3 direction = unit(seven[k].second);
    const double u = direction[request.axis];
    result.lines.push_back({std::string(seven[k].first), direction, before[k], after[k], change * u * u * 1e6});
  }
  return result;
}

}  // namespace axiometry::app::lee
