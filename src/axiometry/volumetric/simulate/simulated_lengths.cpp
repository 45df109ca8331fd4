// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/simulate/simulated_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "axiometry/numeric/random/random.h"
#include "axiometry/volumetric/identify/identifier.h"
#include "axiometry/volumetric/plan/point_set.h"
#include "axiometry/volumetric/simulate/random_streams.h"

namespace axiometry::volumetric {
namespace {

constexpr double nearest_mm = 1.0;
constexpr double jump_least_um = 20.0;
constexpr double jump_most_um = 2000.0;

std::vector<double> uniforms(Draw draw, detail::Stream stream, std::size_t count) {
  std::vector<double> numbers(count);
  numeric::fill_uniform({draw.seed, stream, draw.trial}, numbers);
  return numbers;
}
std::vector<double> normals(Draw draw, detail::Stream stream, std::size_t count) {
  std::vector<double> numbers(count);
  numeric::fill_normal({draw.seed, stream, draw.trial}, numbers);
  return numbers;
}

/// Some of the places that may be taken, each with a size of either sign.
struct Taken {
  std::size_t place = 0;
  double size_um = 0.0;
};
std::vector<Taken> take(std::vector<std::size_t> from, std::size_t count, Draw draw, detail::Stream stream) {
  const std::vector<double> u = uniforms(draw, stream, 2 * count);
  std::vector<Taken> taken;
  for (std::size_t k = 0; k < count && !from.empty(); ++k) {
    const auto at = static_cast<std::ptrdiff_t>(u[2 * k] * static_cast<double>(from.size()));
    const double signed_share = 2.0 * u[2 * k + 1] - 1.0;
    taken.push_back({from[static_cast<std::size_t>(at)],
                     std::copysign(jump_least_um, signed_share) + (jump_most_um - jump_least_um) * signed_share});
    from.erase(from.begin() + at);
  }
  std::ranges::sort(taken, {}, &Taken::place);
  return taken;
}

bool is_same_run(const Visit& a, const Visit& b) { return a.station == b.station && a.tool == b.tool; }

std::vector<Approaches> approaches_of(const std::vector<Visit>& visits) {
  std::vector<VolumetricReading> readings;
  for (const Visit& visit : visits) readings.push_back({visit.station, visit.tool, 0, visit.axes_mm, 0.0});
  std::vector<Approaches> approaches = detail::directions_of_rest(readings);
  for (Approaches& of_axes : approaches) std::ranges::replace(of_axes, 0.0, 1.0);
  return approaches;
}

Result<void> check(const MachineModel& machine, const std::vector<Visit>& visits, const SimulatedFaults& faults) {
  if (machine.stations.empty()) return fail("found no station, expected at least one");
  if (visits.empty()) return fail("found no points, expected at least one of each station and tool");
  for (const std::size_t count : {faults.told_breaks, faults.untold_breaks, faults.lost, faults.outliers})
    if (count > visits.size() / 4)
      return fail(
          fmt::format("found {} faults in {} readings, expected at most a quarter of each kind", count, visits.size()));
  return {};
}

}  // namespace

std::vector<Visit> spread_visits(const MachineModel& machine, std::size_t points, Draw draw) {
  std::vector<Visit> visits;
  const std::vector<double> shifts =
      uniforms(draw, detail::stream_points, 3 * machine.stations.size() * machine.tools.size());
  std::size_t at = 0;
  for (std::size_t s = 0; s < machine.stations.size(); ++s)
    for (std::size_t t = 0; t < machine.tools.size(); ++t, at += 3)
      for (const Vector3& q : spread_points(machine.travel, points, {shifts[at], shifts[at + 1], shifts[at + 2]}))
        visits.push_back({s, t, q});
  return visits;
}

std::vector<Visit> in_any_order(std::vector<Visit> visits, Draw draw) {
  const std::vector<double> u = uniforms(draw, detail::stream_order, visits.size());
  for (std::size_t begin = 0, end = 0; begin < visits.size(); begin = end) {
    while (end < visits.size() && is_same_run(visits[begin], visits[end])) ++end;
    for (std::size_t left = end - begin; left > 1; --left) {  // shuffle of Fisher and Yates
      const std::size_t last = begin + left - 1;
      std::swap(visits[last], visits[begin + static_cast<std::size_t>(u[last] * static_cast<double>(left))]);
    }
  }
  return visits;
}

SimulatedCourse simulated_course(const MachineModel& machine, const SimulationChoices& choices, Draw draw) {
  SimulatedCourse course{.errors = choices.errors != nullptr
                                       ? *choices.errors
                                       : with_drawn_reversal(drawn_errors(machine.travel, choices.size, draw),
                                                             machine.travel, choices.reversal, choices.size, draw),
                         .visits = {choices.visits.begin(), choices.visits.end()}};
  if (!course.visits.empty()) return course;
  course.visits = spread_visits(machine, choices.points, draw);
  if (course.errors.has_reversal() || choices.reversal != Reversal::none)
    course.visits = in_any_order(std::move(course.visits), draw);
  return course;
}

Result<SimulatedLengths> simulate_lengths(const MachineModel& machine, const TrueErrors& errors,
                                          const std::vector<Visit>& all, const SimulatedFaults& faults, Draw draw) {
  AXIOMETRY_TRY_VOID(check(machine, all, faults));
  SimulatedLengths simulated;
  std::vector<std::size_t> places(all.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  std::vector<Visit> visits;
  const std::vector<Approaches> all_approaches = approaches_of(all);
  std::vector<Approaches> approaches;
  {
    std::set<std::size_t> lost;
    for (const Taken& t : take(places, faults.lost, draw, detail::stream_lost)) lost.insert(t.place);
    for (std::size_t i = 0; i < all.size(); ++i) {
      (lost.contains(i) ? simulated.lost : visits).push_back(all[i]);
      if (!lost.contains(i)) approaches.push_back(all_approaches[i]);
    }
  }
  std::vector<std::size_t> inner, any;  // a break before the first reading of a run changes nothing
  for (std::size_t i = 0; i < visits.size(); ++i) {
    any.push_back(i);
    if (i > 0 && is_same_run(visits[i - 1], visits[i])) inner.push_back(i);
  }
  for (const bool told : {true, false}) {
    const auto stream = told ? detail::stream_told_break : detail::stream_untold_break;
    for (const Taken& t : take(inner, told ? faults.told_breaks : faults.untold_breaks, draw, stream)) {
      simulated.jumps.push_back({t.place, t.size_um, told});
      std::erase(inner, t.place);
    }
  }
  std::ranges::sort(simulated.jumps, {}, &SimulatedJump::before_reading);
  std::vector<double> wrong(visits.size(), 0.0);
  for (const Taken& t : take(any, faults.outliers, draw, detail::stream_outlier)) {
    simulated.outliers.push_back({t.place, t.size_um});
    wrong[t.place] = t.size_um;
  }

  const std::size_t runs = machine.stations.size() * machine.tools.size();
  const std::vector<double> dead = uniforms(draw, detail::stream_dead_path, runs);
  const std::vector<double> drifts = normals(draw, detail::stream_drift, runs);
  const std::vector<double> scales = normals(draw, detail::stream_scale, machine.stations.size() + runs);
  const std::vector<double> noise = normals(draw, detail::stream_noise, visits.size());
  VolumetricLengths& lengths = simulated.lengths;
  for (const NamedStation& station : machine.stations) lengths.stations.push_back(station.name);
  for (const Tool& tool : machine.tools) lengths.tools.push_back(tool.name);
  const double of_station = faults.part_scale_um_per_m * std::sqrt(faults.share_of_station);
  const double of_run = faults.part_scale_um_per_m * std::sqrt(1.0 - faults.share_of_station);
  auto jump = simulated.jumps.begin();
  std::size_t begin = 0, end = 0, segment = 0;
  double jumped_um = 0.0;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Visit& visit = visits[i];
    const std::size_t run = visit.station * machine.tools.size() + visit.tool;
    if (i == end) {
      begin = i;
      while (end < visits.size() && is_same_run(visits[begin], visits[end])) ++end;
      segment = 0;
      jumped_um = 0.0;
      simulated.dead_paths.push_back(
          {visit.station, visit.tool, 100.0 + 700.0 * dead[run], faults.drift_um * drifts[run],
           of_station * scales[visit.station] + of_run * scales[machine.stations.size() + run]});
    }
    for (; jump != simulated.jumps.end() && jump->before_reading == i; ++jump) {
      jumped_um += jump->jump_um;
      if (jump->told) ++segment;
    }
    while (lengths.segments.size() <= segment)
      lengths.segments.push_back(fmt::format("{}", lengths.segments.size() + 1));
    const Vector3 tool = machine.tools[visit.tool].offset_mm;
    const Vector3 delta = displacement_exact_um(machine, errors.at(visit.axes_mm, approaches[i]), visit.axes_mm, tool);
    const SimulatedDeadPath& path = simulated.dead_paths.back();
    const Vector3 at = (1.0 + 1e-6 * path.scale_um_per_m) * visit.axes_mm + tool + 1e-3 * delta;
    const double d = distance(at, machine.stations[visit.station].at_mm);
    if (d < nearest_mm)
      return fail(fmt::format("found a point at the station {} itself, expected it elsewhere",
                              machine.stations[visit.station].name));
    const double along = end - begin > 1 ? static_cast<double>(i - begin) / static_cast<double>(end - begin - 1) : 0.0;
    const double added_um =
        path.drift_um * along + jumped_um + wrong[i] + (faults.noise ? machine.sigma_um(d) * noise[i] : 0.0);
    lengths.readings.push_back(
        {visit.station, visit.tool, segment, visit.axes_mm, d - path.dead_path_mm + 1e-3 * added_um});
    simulated.displacements_um.push_back(delta);
  }
  return simulated;
}

}  // namespace axiometry::volumetric
