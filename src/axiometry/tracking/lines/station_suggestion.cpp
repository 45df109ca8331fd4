// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <vector>

#include "axiometry/tracking/geometry/obstacles.h"
#include "axiometry/tracking/geometry/visibility.h"
#include "axiometry/tracking/lines/line_attempt.h"
#include "axiometry/tracking/lines/seven_lines.h"

namespace axiometry::tracking {
namespace {

constexpr double inside_mm = 10.0;        // kept from a limit: unlocated, a station is known to some millimetres
constexpr double outside_share = 0.25;    // share of the travel by which a table may be larger
constexpr int divisions_flat = 16;        // grid divisions when X and Y may change
constexpr int divisions_space = 8;        // grid divisions when Z may change, too
constexpr double smallest_step_mm = 1.0;  // step at which the refinement ends
constexpr double worth_mm = 1e-6;         // a gain below is rounding
constexpr std::size_t refined_starts = 3;

struct Score {
  std::size_t lines = 0;
  double shortest = 0.0;
  double total = 0.0;
  Vector3 axis;

  bool above(const Score& other) const {
    if (lines != other.lines) return lines > other.lines;
    if (std::abs(shortest - other.shortest) > worth_mm) return shortest > other.shortest;
    return total > other.total + worth_mm;
  }
};

/// What one place is worth. Each direction of each line is judged once; axes of the reflector only choose among them.
class Judge {
 public:
  Judge(const TrackingSetup& setup, std::span<const std::string> ids, DiagonalRule rule, bool turn_reflector)
      : setup_(setup), ids_(ids), rule_(rule), incidence_most_(setup.limits.incidence_most_deg) {
    axes_.push_back(unit(setup.limits.reflector_axis));
    for (int x = -1; turn_reflector && x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (x != 0 || y != 0 || z != 0)
            axes_.push_back(unit({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}));
    setup_.limits.incidence_most_deg = 180.0;
  }

  Score of(Vector3 place) {
    setup_.station.position_mm = place;
    for (const Obstacle& obstacle : setup_.obstacles)
      if (distance_to(obstacle, place) < obstacle_margin_mm) return {.axis = axes_.front()};
    std::vector<std::vector<UsableInterval>> usable;
    for (const std::string& id : ids_) {
      std::vector<UsableInterval>& list = usable.emplace_back();
      for (const Vector3& direction : line_directions(setup_, id, rule_))
        if (Attempt one = attempt_line(setup_, id, direction); one.stage == Stage::usable)
          list.push_back(std::move(one.interval));
    }
    Score best = with_axis(usable, axes_.front());
    for (std::size_t k = 1; k < axes_.size(); ++k)
      if (const Score score = with_axis(usable, axes_[k]); score.above(best)) best = score;
    return best;
  }

 private:
  Score with_axis(const std::vector<std::vector<UsableInterval>>& usable, Vector3 axis) const {
    Score score{.axis = axis};
    for (const auto& list : usable) {
      double longest = 0.0;
      for (const UsableInterval& one : list)
        if (incidence_deg(one.direction, axis) <= incidence_most_ + 1e-7) longest = std::max(longest, one.length_mm());
      if (longest <= 0.0) continue;
      score.shortest = score.lines == 0 ? longest : std::min(score.shortest, longest);
      score.total += longest;
      ++score.lines;
    }
    return score;
  }

  TrackingSetup setup_;
  std::span<const std::string> ids_;
  DiagonalRule rule_;
  double incidence_most_;
  std::vector<Vector3> axes_;
};

struct ScoredPlace {
  Vector3 place;
  Score score;
};

/// Where the instrument may stand: the reach of the reflector with some margin, and around it.
struct Region {
  Vector3 lowest, highest, inner_lowest, inner_highest;
};
Region region_of(const TrackingSetup& setup) {
  const Vector3 low = setup.travel.lowest_mm + setup.tool_offset_mm,
                high = setup.travel.highest_mm + setup.tool_offset_mm;
  Region region{low, high, low, high};
  for (std::size_t k = 0; k < 3; ++k) {
    const double margin = std::min(inside_mm, 0.25 * (high[k] - low[k]));
    region.inner_lowest[k] += margin;
    region.inner_highest[k] -= margin;
    const double around = k == 2 ? 0.0 : outside_share * (high[k] - low[k]);
    region.lowest[k] -= around;
    region.highest[k] += around;
  }
  region.lowest.z = region.inner_lowest.z;
  region.highest.z = region.inner_highest.z;
  return region;
}

std::vector<double> coordinates(const Region& region, Vector3 given, std::size_t k, bool may_move, int divisions) {
  if (!may_move) return {given[k]};
  std::vector<double> list = {region.inner_lowest[k], region.inner_highest[k]};
  for (int i = 0; i <= divisions; ++i) {
    const double x = std::round(region.lowest[k] + i * (region.highest[k] - region.lowest[k]) / divisions);
    if (x >= region.lowest[k] && x <= region.highest[k]) list.push_back(x);
  }
  std::ranges::sort(list);
  const auto [end, last] = std::ranges::unique(list);
  list.erase(end, last);
  return list;
}

/// Near a limit but not on it: moved inside.
Vector3 off_the_limits(const Region& region, Vector3 place, const std::array<bool, 3>& may_move) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!may_move[k]) continue;
    const double low = region.inner_lowest[k] - inside_mm, high = region.inner_highest[k] + inside_mm;
    if (place[k] >= low && place[k] < region.inner_lowest[k]) place[k] = region.inner_lowest[k];
    if (place[k] <= high && place[k] > region.inner_highest[k]) place[k] = region.inner_highest[k];
  }
  return place;
}

/// Steps along the axes, halved when none of them gains.
ScoredPlace refined(Judge& judge, const Region& region, ScoredPlace best, Vector3 step,
                    const std::array<bool, 3>& may_move) {
  while (std::max({step.x, step.y, step.z}) >= smallest_step_mm) {
    bool gained = false;
    for (std::size_t k = 0; k < 3; ++k)
      for (double sign : {-1.0, 1.0}) {
        if (!may_move[k]) continue;
        Vector3 place = best.place;
        place[k] = std::clamp(std::round(place[k] + sign * step[k]), region.lowest[k], region.highest[k]);
        place = off_the_limits(region, place, may_move);
        if (const Score score = judge.of(place); score.above(best.score)) {
          best = {place, score};
          gained = true;
        }
      }
    if (!gained) step = 0.5 * step;
  }
  return best;
}

}  // namespace

StationSuggestion suggest_station(const TrackingSetup& setup, std::span<const std::string> ids, DiagonalRule rule,
                                  const StationFreedom& freedom) {
  Judge judge(setup, ids, rule, freedom.turn_reflector);
  const Region region = region_of(setup);
  const Vector3 given = setup.station.position_mm;
  const auto& may_move = freedom.may_move;
  const int divisions = may_move[2] ? divisions_space : divisions_flat;
  const ScoredPlace as_given{given, judge.of(given)};
  std::vector<ScoredPlace> found = {as_given};
  for (double x : coordinates(region, given, 0, may_move[0], divisions))
    for (double y : coordinates(region, given, 1, may_move[1], divisions))
      for (double z : coordinates(region, given, 2, may_move[2], divisions)) {
        const Vector3 place = off_the_limits(region, {x, y, z}, may_move);
        found.push_back({place, judge.of(place)});
      }
  const auto rank = [](const ScoredPlace& one) {
    return std::tuple(one.score.lines, one.score.shortest, one.score.total);  // exact: an order that sorting can trust
  };
  std::ranges::stable_sort(found, std::ranges::greater{}, rank);
  ScoredPlace best = as_given;
  if (found.front().score.above(best.score)) best = found.front();
  const Vector3 step = 1.0 / divisions * (region.highest - region.lowest);
  for (std::size_t k = 0; k < std::min(refined_starts, found.size()); ++k)
    if (const ScoredPlace one = refined(judge, region, found[k], step, may_move); one.score.above(best.score))
      best = one;
  return {.position_mm = best.place,
          .lines = best.score.lines,
          .shortest_mm = best.score.shortest,
          .total_mm = best.score.total,
          .reflector_axis = best.score.axis};
}

}  // namespace axiometry::tracking
