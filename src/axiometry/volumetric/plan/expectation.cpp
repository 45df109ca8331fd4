// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/plan/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

#include "axiometry/volumetric/field/point_spread.h"
#include "axiometry/volumetric/field/unseen_reasons.h"
#include "axiometry/volumetric/identify/common_scale.h"
#include "axiometry/volumetric/identify/equations/linear_solution.h"
#include "axiometry/volumetric/identify/equations/shape_rank.h"

namespace axiometry::volumetric {
namespace {

using detail::LinearSolution;
using detail::Problem;
using detail::State;
using detail::Unknowns;

constexpr std::size_t curve_places = 41;
constexpr std::size_t field_places = 7;  // places along each axis

double place_of(const TravelBox& travel, std::size_t axis, std::size_t k, std::size_t count) {
  const double share = static_cast<double>(k) / static_cast<double>(count - 1);
  return travel.lowest_mm[axis] + share * (travel.highest_mm[axis] - travel.lowest_mm[axis]);
}

Result<void> check_visits(const MachineModel& machine, std::span<const Visit> visits) {
  if (machine.stations.empty()) return fail("found no station, expected at least one");
  if (visits.empty()) return fail("found no points, expected some of each station and tool");
  constexpr double slack_mm = 0.01, nearest_mm = 1.0;
  for (const Visit& visit : visits) {
    for (std::size_t a = 0; a < axis_count; ++a)
      if (!(visit.axes_mm[a] >= machine.travel.lowest_mm[a] - slack_mm &&
            visit.axes_mm[a] <= machine.travel.highest_mm[a] + slack_mm))
        return fail(
            fmt::format("found a point with {} at {} mm, expected it within the travel", "XYZ"[a], visit.axes_mm[a]));
    const NamedStation& station = machine.stations[visit.station];
    if (distance(visit.axes_mm + machine.tools[visit.tool].offset_mm, station.at_mm) < nearest_mm)
      return fail(fmt::format("found a point at the station {} itself, expected it elsewhere", station.name));
  }
  return {};
}

/// Mean and largest of what is told; nothing when one is not.
class Spread {
 public:
  void add(std::optional<double> variance) {
    if (!variance) {
      all_told_ = false;
      return;
    }
    sum_ += *variance;
    most_ = std::max(most_, *variance);
    ++count_;
  }
  std::optional<double> rms() const {
    if (!all_told_ || count_ == 0) return std::nullopt;
    return std::sqrt(sum_ / static_cast<double>(count_));
  }
  std::optional<double> most() const {
    if (!all_told_ || count_ == 0) return std::nullopt;
    return std::sqrt(most_);
  }

 private:
  bool all_told_ = true;
  double sum_ = 0.0, most_ = 0.0;
  std::size_t count_ = 0;
};

std::optional<double> variance_of(const std::optional<Estimate>& estimate) {
  if (!estimate) return std::nullopt;
  return estimate->u * estimate->u;
}

void take_errors(const ErrorModel& model, Expectation& expected) {
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      Spread spread;
      for (std::size_t k = 0; k < curve_places; ++k)
        spread.add(variance_of(model.motion({a, m}, place_of(model.machine().travel, a, k, curve_places))));
      expected.errors[a * motion_count + m] = {spread.rms(), spread.most()};
    }
  for (std::size_t k = 0; k < squareness_names.size(); ++k) {
    Spread spread;
    spread.add(variance_of(model.squareness(static_cast<Squareness>(k))));
    expected.errors[axis_count * motion_count + k] = {spread.rms(), spread.most()};
  }
}

void take_field(const ErrorModel& model, Expectation& expected) {
  const TravelBox& travel = model.machine().travel;
  Spread all;
  for (std::size_t t = 0; t < model.machine().tools.size(); ++t) {
    Spread own;
    for (std::size_t i = 0; i < field_places * field_places * field_places; ++i) {
      const Vector3 q = {place_of(travel, 0, i % field_places, field_places),
                         place_of(travel, 1, i / field_places % field_places, field_places),
                         place_of(travel, 2, i / field_places / field_places, field_places)};
      const ToolPointError field = model.at(q, model.machine().tools[t].offset_mm);
      std::optional<double> variance;
      if (field.is_whole())
        variance = field.covariance_um2[0][0] + field.covariance_um2[1][1] + field.covariance_um2[2][2];
      own.add(variance);
      all.add(variance);
    }
    expected.tools.push_back({t, own.rms(), own.most()});
  }
  expected.u_rms_um = all.rms();
  expected.u_most_um = all.most();
}

std::vector<std::string> reasons_of(const MachineModel& machine, std::span<const Visit> visits) {
  SetupShape setup;
  std::vector<bool> station(machine.stations.size(), false), tool(machine.tools.size(), false);
  for (const Visit& visit : visits) {
    if (!station[visit.station]) setup.stations_mm.push_back(machine.stations[visit.station].at_mm);
    if (!tool[visit.tool]) setup.tools_mm.push_back(machine.tools[visit.tool].offset_mm);
    station[visit.station] = tool[visit.tool] = true;
  }
  return unseen_reasons(setup);
}

/// The normal equations of a plan, solved.
struct Solved {
  LinearSolution solution;
  ErrorModel model;
  std::size_t null_directions = 0;
};

/// With the tools that are used as they count for identify().
MachineModel with_seen_tools(MachineModel machine, std::span<const Visit> visits) {
  std::vector<bool> is_used(machine.tools.size(), false);
  for (const Visit& visit : visits) is_used[visit.tool] = true;
  std::vector<Vector3> offsets;
  for (std::size_t t = 0; t < machine.tools.size(); ++t)
    if (is_used[t]) offsets.push_back(machine.tools[t].offset_mm);
  offsets = seen_offsets(std::move(offsets));
  std::size_t next = 0;
  for (std::size_t t = 0; t < machine.tools.size(); ++t)
    if (is_used[t]) machine.tools[t].offset_mm = offsets[next++];
  return machine;
}

Result<Solved> solve(const MachineModel& stated, std::span<const Visit> visits, const ExpectOptions& options) {
  AXIOMETRY_TRY_VOID(check_visits(stated, visits));
  AXIOMETRY_TRY(const Coefficients coefficients,
                Coefficients::make(options.curves, stated.travel, options.sizes, Reversal::none));
  std::vector<VolumetricReading> readings;
  std::vector<double> weights;
  const MachineModel machine = with_seen_tools(stated, visits);
  std::vector<Vector3> tools_mm;
  for (const Tool& tool : machine.tools) tools_mm.push_back(tool.offset_mm);
  for (const Visit& visit : visits) {
    const double d = distance(visit.axes_mm + tools_mm[visit.tool], machine.stations[visit.station].at_mm);
    readings.push_back({visit.station, visit.tool, 0, visit.axes_mm, d});
    const double sigma = machine.sigma_um(d);
    weights.push_back(1.0 / (sigma * sigma));
  }
  const Unknowns unknowns = detail::unknowns_of(coefficients, readings, {}, options.drift);
  State state;
  state.coefficients.assign(coefficients.raw(), 0.0);
  for (const detail::VirtualStation& v : unknowns.stations)
    state.stations_mm.push_back(machine.stations[v.station].at_mm);
  state.dead_paths_mm.assign(unknowns.stretches.size(), 0.0);
  state.drifts_um.assign(unknowns.stretches.size(), 0.0);
  const Problem problem{machine,  coefficients, unknowns, readings,
                        tools_mm, {},           weights,  std::max(1u, std::thread::hardware_concurrency())};
  const detail::Sights seen = detail::sights(problem, state);
  LinearSolution solution = detail::linear_solution(problem, state, detail::normal_equations(problem, seen));
  std::vector<double> covariance = solution.coefficient_covariance();
  detail::add_common_scale(problem, state, seen.beams, solution, covariance);
  std::vector<std::vector<double>> unseen = solution.unseen();
  const auto by_shape = detail::told_by_shape_alone(problem, state);
  unseen.insert(unseen.end(), by_shape.begin(), by_shape.end());
  const std::size_t nulls = std::max(solution.null_directions(), by_shape.size());
  ErrorModel model(
      {machine, coefficients, state.coefficients, std::move(covariance), std::move(unseen), machine.travel});
  return Solved{std::move(solution), std::move(model), nulls};
}

}  // namespace

Result<Expectation> expect(const MachineModel& machine, std::span<const Visit> visits, const ExpectOptions& options) {
  AXIOMETRY_TRY(const Solved solved, solve(machine, visits, options));
  Expectation expected;
  expected.rank = {solved.solution.unknowns(), solved.model.coefficients().free(), solved.null_directions,
                   solved.solution.condition()};
  expected.readings = visits.size();
  expected.unseen = solved.model.unseen_errors();
  if (!expected.unseen.empty()) expected.reasons = reasons_of(machine, visits);
  take_errors(solved.model, expected);
  take_field(solved.model, expected);
  return expected;
}

double expected_score(const MachineModel& machine, std::span<const Visit> visits) {
  constexpr double per_null_um = 1000.0;
  const auto solved = solve(machine, visits, {.curves = CurveKind::legendre, .sizes = {3, 3, 3}});
  if (!solved) return std::numeric_limits<double>::infinity();
  const TravelBox& travel = machine.travel;
  double sum = 0.0, count = 0.0;
  for (const Tool& tool : machine.tools)
    for (std::size_t i = 0; i < 9; ++i) {
      Vector3 q;
      for (std::size_t a = 0; a < axis_count; ++a)
        q[a] = i == 8 ? place_of(travel, a, 1, 3) : place_of(travel, a, (i >> a) & 1, 2);
      const ToolPointError field = solved->model.at(q, tool.offset_mm);
      for (std::size_t k = 0; k < 3; ++k) sum += field.covariance_um2[k][k];
      count += 1.0;
    }
  return std::sqrt(sum / count) + per_null_um * static_cast<double>(solved->null_directions);
}

}  // namespace axiometry::volumetric
