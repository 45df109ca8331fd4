// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "axiometry/base/go_on_unless.h"
#include "axiometry/tracking/geometry/visibility.h"
#include "axiometry/volumetric/plan/planner.h"
#include "axiometry/volumetric/plan/point_set.h"

namespace axiometry::volumetric {
namespace {

constexpr double room_beyond = 0.15;
constexpr double room_height = 0.25;
constexpr std::array<std::size_t, 3> grid = {5, 4, 3};
constexpr std::size_t points_looked_at = 24;
constexpr double seen_least = 0.25;
constexpr double apart_least_mm = 200.0;
constexpr double heights_apart_mm = 50.0;
constexpr std::size_t exchange_rounds = 3;

/// Where an instrument could stand, and what it sees of the points that are looked at, by tool.
struct Candidate {
  Vector3 at_mm;
  std::vector<Visit> visible;  ///< visits that the station sees, with station number 0
};

Vector3 grid_place(const TravelBox& room, std::size_t i) {
  Vector3 at;
  for (std::size_t a = 0; a < 3; ++a) {
    at[a] = room.lowest_mm[a] + static_cast<double>(i % grid[a]) / static_cast<double>(grid[a] - 1) *
                                    (room.highest_mm[a] - room.lowest_mm[a]);
    at[a] = std::round(at[a]);
    i /= grid[a];
  }
  return at;
}

/// Absent when a tool is seen at too few points.
std::optional<Candidate> candidate_at(const CalibrationPlan& base, Vector3 at, std::map<std::string, int>& reasons) {
  CalibrationPlan plan = base;
  plan.machine.stations = {{"S", at}};
  Candidate candidate{at, {}};
  bool enough = true;
  for (std::size_t t = 0; t < plan.machine.tools.size(); ++t) {
    const TrackingSetup setup = setup_of(plan, 0, t);
    const double shift = 0.37 * static_cast<double>(t);
    std::size_t seen = 0;
    for (const Vector3& q : spread_points(plan.machine.travel, points_looked_at, {shift, shift, shift})) {
      const Vector3 p = q + setup.tool_offset_mm;
      auto why = tracking::hidden_because(setup, p);
      if (!why) why = tracking::blocked_because(setup, p, p);
      if (why) {
        ++reasons[*why];
        continue;
      }
      ++seen;
      candidate.visible.push_back({0, t, q});
    }
    enough = enough && static_cast<double>(seen) >= seen_least * static_cast<double>(points_looked_at);
  }
  if (!enough) return std::nullopt;
  return candidate;
}

bool is_allowed(const std::vector<const Candidate*>& chosen) {
  double low = chosen.front()->at_mm.z, high = low;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    low = std::min(low, chosen[i]->at_mm.z);
    high = std::max(high, chosen[i]->at_mm.z);
    for (std::size_t k = 0; k < i; ++k)
      if (distance(chosen[i]->at_mm, chosen[k]->at_mm) < apart_least_mm) return false;
  }
  return chosen.size() < 2 || high - low >= heights_apart_mm;
}

/// Small is good.
double score_of(const MachineModel& machine, const std::vector<const Candidate*>& chosen) {
  MachineModel model = machine;
  model.stations.clear();
  std::vector<Visit> visits;
  for (std::size_t s = 0; s < chosen.size(); ++s) {
    model.stations.push_back({"S", chosen[s]->at_mm});
    for (Visit visit : chosen[s]->visible) {
      visit.station = s;
      visits.push_back(visit);
    }
  }
  return expected_score(model, visits);
}

}  // namespace

TravelBox station_room(const MachineModel& machine) {
  TravelBox room = machine.travel;
  for (std::size_t a = 0; a < 3; ++a) {
    double lowest = machine.tools.front().offset_mm[a], highest = lowest;
    for (const Tool& tool : machine.tools) {
      lowest = std::min(lowest, tool.offset_mm[a]);
      highest = std::max(highest, tool.offset_mm[a]);
    }
    const double travel = machine.travel.highest_mm[a] - machine.travel.lowest_mm[a];
    const double reach = room.lowest_mm[a] + lowest;
    room.lowest_mm[a] = reach - (a < 2 ? room_beyond : room_height) * travel;
    room.highest_mm[a] = a < 2 ? room.highest_mm[a] + highest + room_beyond * travel : reach + room_height * travel;
  }
  return room;
}

Result<std::vector<NamedStation>> propose_stations(const CalibrationPlan& plan, const PlanOptions& options) {
  const TravelBox room = options.room.value_or(station_room(plan.machine));
  std::vector<Candidate> candidates;
  std::map<std::string, int> reasons;
  for (std::size_t i = 0; i < grid[0] * grid[1] * grid[2]; ++i) {
    AXIOMETRY_TRY_VOID(go_on_unless(options.stop));
    if (auto candidate = candidate_at(plan, grid_place(room, i), reasons)) candidates.push_back(*std::move(candidate));
  }
  const std::size_t count = options.stations;
  const auto too_few = [&]() -> std::unexpected<Error> {
    const auto most = std::ranges::max_element(reasons, {}, [](const auto& r) { return r.second; });
    return fail(
        fmt::format("found {} places for the instrument that see a quarter of the points with each tool, "
                    "expected at least {} of them 200 mm apart and at two heights{}: allow other limits, or "
                    "other places",
                    candidates.size(), count,
                    most == reasons.end() ? "" : fmt::format(" (most often in the way: {})", most->first)));
  };
  if (candidates.size() < count) return too_few();
  // Begin with those that see the most, each allowed beside those before.
  std::vector<const Candidate*> order;
  for (const Candidate& candidate : candidates) order.push_back(&candidate);
  std::ranges::stable_sort(order, std::greater(), [](const Candidate* c) { return c->visible.size(); });
  std::vector<const Candidate*> chosen;
  for (const Candidate* candidate : order) {
    if (chosen.size() == count) break;
    std::vector<const Candidate*> more = chosen;
    more.push_back(candidate);
    const bool last = more.size() == count || more.size() < 2;
    const bool apart = std::ranges::all_of(
        chosen, [&](const Candidate* c) { return distance(c->at_mm, candidate->at_mm) >= apart_least_mm; });
    if (last ? is_allowed(more) : apart) chosen = std::move(more);
  }
  if (chosen.size() < count) return too_few();
  double best = score_of(plan.machine, chosen);
  for (std::size_t round = 0; round < exchange_rounds; ++round) {
    bool gains = false;
    for (std::size_t s = 0; s < count; ++s)
      for (const Candidate& other : candidates) {
        std::vector<const Candidate*> next = chosen;
        next[s] = &other;
        if (&other == chosen[s] || !is_allowed(next)) continue;
        AXIOMETRY_TRY_VOID(go_on_unless(options.stop));
        const double score = score_of(plan.machine, next);
        if (!(score < best * (1.0 - 1e-9))) continue;
        best = score;
        chosen = std::move(next);
        gains = true;
      }
    if (!gains) break;
  }
  std::vector<NamedStation> stations;
  for (const Candidate* candidate : chosen)
    stations.push_back({fmt::format("S{}", stations.size() + 1), candidate->at_mm});
  return stations;
}

}  // namespace axiometry::volumetric
