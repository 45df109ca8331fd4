// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <set>

#include "axiometry/tracking/geometry/machine_axes.h"
#include "axiometry/tracking/geometry/visibility.h"

namespace axiometry::tracking {
namespace {

constexpr int grid_divisions = 6;         // divisions of each travel
constexpr double beside_sphere_mm = 5.0;  // distance kept beyond the safe radius
constexpr double not_reached = std::numeric_limits<double>::infinity();

/// Way points of the axes, first and last included.
using Way = std::vector<Vector3>;

double length_of(const Way& way) {
  double sum = 0.0;
  for (std::size_t k = 1; k < way.size(); ++k) sum += distance(way[k - 1], way[k]);
  return sum;
}

class Search {
 public:
  Search(const TrackingSetup& setup, Vector3 from, Vector3 to) : setup_(setup), from_(from), to_(to) {
    for (std::size_t k = 0; k < 3; ++k) levels_[k] = levels(k);
  }

  std::optional<Way> straight(bool keep_beam) const { return checked({from_, to_}, keep_beam); }

  /// Z up, across, Z down, over the lowest plane that is free.
  std::optional<Way> lifted(bool keep_beam) const {
    for (double z : levels_[2]) {
      if (z < std::max(from_.z, to_.z)) continue;
      Way way{from_};
      for (const Vector3 corner : {Vector3{from_.x, from_.y, z}, Vector3{to_.x, to_.y, z}})
        if (corner != way.back() && corner != to_) way.push_back(corner);
      way.push_back(to_);
      if (auto found = checked(std::move(way), keep_beam)) return found;
    }
    return std::nullopt;
  }

  /// The shortest way over the grid (A*), then without the points that it does not need. Of the beam only the ends of
  /// each step are looked at while searching; the way found is judged exactly.
  std::optional<Way> around(bool keep_beam) const {
    const std::size_t count = levels_[0].size() * levels_[1].size() * levels_[2].size();
    std::vector<double> cost(count, not_reached);
    std::vector<std::size_t> before(count, count);
    using Entry = std::pair<double, std::size_t>;  // ties by the number of the node: the same way every time
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const std::size_t begin = node_at(from_), end = node_at(to_);
    cost[begin] = 0.0;
    open.emplace(distance(from_, to_), begin);
    std::vector<char> done(count, 0);
    while (!open.empty()) {
      const std::size_t node = open.top().second;
      open.pop();
      if (node == end) break;
      if (std::exchange(done[node], 1) != 0) continue;
      for (std::size_t next : neighbours(node)) {
        const double sum = cost[node] + distance(place(node), place(next));
        if (done[next] != 0 || sum >= cost[next] || !may_step(node, next, keep_beam)) continue;
        cost[next] = sum;
        before[next] = node;
        open.emplace(sum + distance(place(next), to_), next);
      }
    }
    if (cost[end] == not_reached) return std::nullopt;
    Way way;
    for (std::size_t node = end; node != count; node = before[node]) way.push_back(place(node));
    std::ranges::reverse(way);
    return checked(shortened(way, keep_beam), keep_beam);
  }

 private:
  Vector3 reflector(Vector3 axes) const { return axes + setup_.tool_offset_mm; }

  bool free(Vector3 a, Vector3 b, bool keep_beam) const {
    if (blocked_because(setup_, reflector(a), reflector(b))) return false;
    return !keep_beam || !beam_lost_because(setup_, reflector(a), reflector(b));
  }

  std::optional<Way> checked(Way way, bool keep_beam) const {
    for (std::size_t k = 1; k < way.size(); ++k)
      if (!free(way[k - 1], way[k], keep_beam)) return std::nullopt;
    return way;
  }

  /// Coordinates of the grid: an even division, both ends of the way, and just beside the sphere of the station.
  std::vector<double> levels(std::size_t k) const {
    const double low = setup_.travel.lowest_mm[k], high = setup_.travel.highest_mm[k];
    const double station = setup_.station.position_mm[k] - setup_.tool_offset_mm[k];
    const double beside = setup_.limits.safe_radius_mm + beside_sphere_mm;
    std::set<double> found = {from_[k], to_[k], low, high};
    for (int i = 1; i < grid_divisions; ++i) found.insert(rounded_to_um(low + i * (high - low) / grid_divisions));
    for (double x : {rounded_to_um(station - beside), rounded_to_um(station + beside)})
      if (x > low && x < high) found.insert(x);
    return {found.begin(), found.end()};
  }

  std::size_t node_at(Vector3 axes) const {
    const auto index = [&](std::size_t k) {
      return static_cast<std::size_t>(std::ranges::find(levels_[k], axes[k]) - levels_[k].begin());
    };
    return (index(0) * levels_[1].size() + index(1)) * levels_[2].size() + index(2);
  }

  std::array<std::size_t, 3> indices(std::size_t node) const {
    const std::size_t ny = levels_[1].size(), nz = levels_[2].size();
    return {node / (ny * nz), node / nz % ny, node % nz};
  }

  Vector3 place(std::size_t node) const {
    const auto [i, j, k] = indices(node);
    return {levels_[0][i], levels_[1][j], levels_[2][k]};
  }

  std::vector<std::size_t> neighbours(std::size_t node) const {
    const auto at = indices(node);
    std::vector<std::size_t> found;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const std::array<int, 3> step = {i, j, k};
          std::size_t next = 0;
          bool inside = i != 0 || j != 0 || k != 0;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto index = static_cast<long long>(at[axis]) + step[axis];
            inside = inside && index >= 0 && index < static_cast<long long>(levels_[axis].size());
            next = next * levels_[axis].size() + (inside ? static_cast<std::size_t>(index) : 0);
          }
          if (inside) found.push_back(next);
        }
    return found;
  }

  bool may_step(std::size_t a, std::size_t b, bool keep_beam) const {
    if (blocked_because(setup_, reflector(place(a)), reflector(place(b)))) return false;
    return !keep_beam || !hidden_because(setup_, reflector(place(b)));
  }

  /// From each point to the farthest that can be reached straight.
  Way shortened(const Way& way, bool keep_beam) const {
    Way kept{way.front()};
    for (std::size_t at = 0; at + 1 < way.size();) {
      std::size_t next = way.size() - 1;
      while (next > at + 1 && !free(way[at], way[next], keep_beam)) --next;
      kept.push_back(way[next]);
      at = next;
    }
    return kept;
  }

  const TrackingSetup& setup_;
  Vector3 from_, to_;
  std::array<std::vector<double>, 3> levels_;
};

Transfer transfer_over(const Way& way, bool beam_kept) {
  return {.over_mm = {way.begin() + 1, way.end() - 1}, .beam_kept = beam_kept};
}

}  // namespace

Result<Transfer> safe_transfer(const TrackingSetup& setup, Vector3 from_axes_mm, Vector3 to_axes_mm) {
  const Vector3 from = from_axes_mm + setup.tool_offset_mm, to = to_axes_mm + setup.tool_offset_mm;
  for (const Vector3& end : {from, to})
    if (const auto reason = blocked_because(setup, end, end))
      return fail(fmt::format("found {}, expected a free place at the {} of a transfer", *reason,
                              end == from ? "beginning" : "end"));
  const Search search(setup, from_axes_mm, to_axes_mm);
  for (bool keep_beam : {true, false}) {
    if (const auto way = search.straight(keep_beam)) return transfer_over(*way, keep_beam);
    auto best = search.lifted(keep_beam);
    const auto around = best ? std::nullopt : search.around(keep_beam);
    if (around && (!best || length_of(*around) < length_of(*best))) best = around;
    if (best) return transfer_over(*best, keep_beam);
  }
  return fail(fmt::format("found no way from ({}, {}, {}) to ({}, {}, {}) mm, expected one; straight on: {}",
                          from_axes_mm.x, from_axes_mm.y, from_axes_mm.z, to_axes_mm.x, to_axes_mm.y, to_axes_mm.z,
                          *blocked_because(setup, from, to)));
}

}  // namespace axiometry::tracking
