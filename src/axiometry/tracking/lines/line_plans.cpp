// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/standards/iso230_6.h"
#include "axiometry/tracking/geometry/visibility.h"
#include "axiometry/tracking/lines/line_attempt.h"
#include "axiometry/tracking/lines/line_order.h"
#include "axiometry/tracking/lines/line_targets.h"
#include "axiometry/tracking/lines/seven_lines.h"
#include "axiometry/tracking/station/length_difference.h"

namespace axiometry::tracking {
namespace {

constexpr double broken_beam_mm = 1e6;          // cost of a lost beam beside the length of a way
constexpr double no_way_mm = 1e9;               // cost of a way that does not exist
constexpr double on_extension_mm = 1.0;         // a station this near to the extension of a diagonal is on it
constexpr double negligible_share = 1.0 / 3.0;  // share of the instrument's uncertainty: it adds 5 % to both together
constexpr double step_least = 1e-6, step_most = 1.0;

bool is_seven(std::string_view id) { return std::ranges::find(seven_lines, id) != seven_lines.end(); }

std::optional<iso230_6::Diagonal> box_diagonal(const TravelBox& box, std::string_view id) {
  for (const auto& list : {iso230_6::body_diagonals(box), iso230_6::face_diagonals(box)})
    for (const iso230_6::Diagonal& diagonal : list)
      if (diagonal.id == id) return diagonal;
  return std::nullopt;
}

/// Sets by their members; each line once.
Result<std::vector<std::string>> wanted_ids(const TrackingSetup& setup, const LinesRequest& request) {
  std::vector<std::string> ids;
  const auto add = [&](const std::string& id) {
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  };
  if (is_aligned(setup) && (request.ids.empty() || std::ranges::any_of(request.ids, is_seven)))
    return fail(
        "found no station, expected its place or the file of a located one: only diagonals of the travels "
        "need none");
  for (const std::string& id : request.ids)
    if (id == "body" || id == "face") {
      for (const auto& diagonal :
           id == "body" ? iso230_6::body_diagonals(setup.travel) : iso230_6::face_diagonals(setup.travel))
        add(diagonal.id);
    } else if (is_seven(id) || box_diagonal(setup.travel, id)) {
      add(id);
    } else {
      return fail(
          fmt::format("found the line {}, expected x, y, z, xy, xz, yz, xyz, body, face or a diagonal such as "
                      "NNN-PPP or NN0-PP0",
                      text::quoted(id)));
    }
  if (request.ids.empty())
    for (std::string_view id : seven_lines) add(std::string(id));
  return ids;
}

Result<void> check_request(const LinesRequest& request) {
  if (!(request.step_mm >= step_least && request.step_mm <= step_most))
    return fail(
        fmt::format("found a step of {} mm, expected {} to {}", format_exact(request.step_mm), step_least, step_most));
  for (const auto& period : request.periods)
    if (period && !(period->in_native() > 0.0 && std::isfinite(period->in_native())))
      return fail(fmt::format("found a period of {} mm, expected one above 0", format_exact(period->in_native())));
  return {};
}

Vector3 begin_of(const Plan& plan) { return spatial_line(plan.axis)->at(reach(plan).lowest); }

/// From above, at the upper end of Z, down to a place: the point above it, and what lies between. Absent where no such
/// way is safe.
std::optional<std::vector<Vector3>> way_from_above(const TrackingSetup& setup, Vector3 place) {
  const Vector3 above{place.x, place.y, setup.travel.highest_mm.z};
  if (above == place) return std::vector<Vector3>{};
  const auto transfer = safe_transfer(setup, above, place);
  if (!transfer) return std::nullopt;
  std::vector<Vector3> way = {above};
  way.insert(way.end(), transfer->over_mm.begin(), transfer->over_mm.end());
  return way;
}

/// Makes the plan line by line; what it drops says why.
class Planner {
 public:
  Planner(const TrackingSetup& setup, const LinesRequest& request) : setup_(setup), request_(request) {
    plan_.title = request.title;
    plan_.machine = request.machine;
    plan_.date = request.date;
    plan_.setup = setup;
  }

  Result<TrackingPlan> make(const std::vector<std::string>& ids) && {
    std::vector<std::string> from_station;
    std::ranges::copy_if(ids, std::back_inserter(from_station), is_seven);
    LineChoice choice = choose_lines(setup_, from_station, request_.rule);
    for (const std::string& id : ids) {
      const auto interval = std::ranges::find(choice.lines, id, &UsableInterval::id);
      const auto lost = std::ranges::find(choice.lost, id, &LostLine::id);
      if (interval != choice.lines.end())
        add_from_station(*interval);
      else if (lost != choice.lost.end())
        plan_.lost.push_back(*lost);
      else
        add_diagonal(*box_diagonal(setup_.travel, id));
    }
    if (plan_.lines.empty()) return fail(why_none());
    order_lines();
    AXIOMETRY_TRY_VOID(connect());
    return std::move(plan_);
  }

 private:
  void add(const LineTask& task) {
    auto line = planned_line(task, request_);
    if (!line) {
      plan_.lost.push_back({task.id, line.error().message});
      return;
    }
    plan_.lines.push_back(*std::move(line));
    const Plan& plan = plan_.lines.back().plan;
    if (moving_axes(task.line) > 1) return;
    for (const iso230_2::Finding& finding : iso230_2::plan_findings(plan))
      if (finding.severity == iso230_2::Severity::departure)
        plan_.remarks.push_back(
            fmt::format("{}: departs from {}, {}: {}", task.id, plan.standard, finding.clause, finding.message));
  }

  void add_from_station(const UsableInterval& interval) {
    LineTask task = task_of(setup_, interval, request_.step_mm);
    const auto number = std::ranges::find(seven_lines, interval.id) - seven_lines.begin();
    task.seed = request_.seed + static_cast<std::uint64_t>(number);
    const std::size_t before = plan_.lines.size();
    add(task);
    if (plan_.lines.size() == before) return;
    if (setup_.station.covariance_mm2) note_length_difference(interval);
    if (task.usable.length() > 2000.0) note_long(interval.id);
  }

  void add_diagonal(const iso230_6::Diagonal& diagonal) {
    const Vector3 begin = diagonal.begin_mm + setup_.tool_offset_mm, end = diagonal.end_mm + setup_.tool_offset_mm;
    if (const auto reason = blocked_because(setup_, begin, end)) {
      plan_.lost.push_back({diagonal.id, *reason});
      return;
    }
    LineTask task = diagonal_task(setup_, diagonal.id, diagonal.begin_mm, diagonal.end_mm, request_.step_mm);
    task.seed = request_.seed + seven_lines.size() + plan_.lines.size() + plan_.lost.size();
    const std::size_t before = plan_.lines.size();
    add(task);
    if (plan_.lines.size() == before) return;
    if (task.usable.length() > 2000.0) note_long(diagonal.id);
    if (is_aligned(setup_)) return;
    const Vector3 u = unit(end - begin), r = setup_.station.position_mm - begin;
    if (const double off = norm(r - dot(r, u) * u); off > on_extension_mm)
      plan_.remarks.push_back(fmt::format(
          "{}: the station is {:.1f} mm beside this diagonal; it needs an interferometer aligned with it, or a station "
          "on its extension",
          diagonal.id, off));
    else if (const auto hidden = beam_lost_because(setup_, begin, end))
      plan_.remarks.push_back(fmt::format("{}: not all of it can be seen from the station: {}", diagonal.id, *hidden));
  }

  void note_long(const std::string& id) {
    const std::size_t runs = plan_.lines.back().plan.runs;
    plan_.remarks.push_back(fmt::format(
        "{}: above 2 000 mm the whole is measured {} in each direction, at five targets per metre, which holds "
        "the test of every 2 000 mm in it",
        id, runs == 1 ? "once" : fmt::format("{} times", runs)));
  }

  /// From which distance on what the station's uncertainty does to the lengths may be left out of the budget.
  void note_length_difference(const UsableInterval& interval) {
    const double from = negligible_from_mm(offset_uncertainty(*setup_.station.covariance_mm2, interval.direction),
                                           setup_.ranging, negligible_share);
    const Plan& plan = plan_.lines.back().plan;
    const SpatialLine line = *spatial_line(plan.axis);
    const auto away = [&](Position p) {
      return distance(line.at(p) + setup_.tool_offset_mm, setup_.station.position_mm);
    };
    const double nearest = std::min(away(plan.targets.front()), away(plan.targets.back()));
    plan_.remarks.push_back(
        from <= nearest
            ? fmt::format("{}: the length difference may be neglected on the whole line, its first target is {:.1f} mm "
                          "from the station{}",
                          interval.id, nearest, from < 0.1 ? "" : fmt::format(", {:.1f} mm would do", from))
        : std::isfinite(from)
            ? fmt::format("{}: the length difference may be neglected from {:.1f} mm on, the first target is {:.1f} mm "
                          "from the station",
                          interval.id, from, nearest)
            : fmt::format("{}: the length difference may not be neglected anywhere", interval.id));
  }

  /// The reason that all share, or that of each.
  std::string why_none() const {
    const auto& lost = plan_.lost;
    const bool alike = std::ranges::all_of(lost, [&](const LostLine& l) { return l.reason == lost.front().reason; });
    if (alike && lost.front().reason.starts_with("found")) return lost.front().reason;
    std::string text(tracking::none_left);
    for (const LostLine& line : lost) text += fmt::format("; {}: {}", line.id, line.reason);
    return text;
  }

  /// Shortest ways, the beam kept before that.
  void order_lines() {
    const std::size_t n = plan_.lines.size();
    std::vector<std::vector<double>> costs(n, std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k)
        if (i != k) costs[i][k] = cost(begin_of(plan_.lines[i].plan), begin_of(plan_.lines[k].plan));
    std::vector<TrackingLine> ordered;
    for (std::size_t k : shortest_order(costs)) ordered.push_back(plan_.lines[k]);
    plan_.lines = std::move(ordered);
  }

  double cost(Vector3 from, Vector3 to) const {
    const auto transfer = safe_transfer(setup_, from, to);
    if (!transfer) return no_way_mm;
    double sum = transfer->beam_kept ? 0.0 : broken_beam_mm;
    Vector3 at = from;
    for (const Vector3& over : transfer->over_mm) {
      sum += distance(at, over);
      at = over;
    }
    return sum + distance(at, to);
  }

  /// A line begins and ends at the overrun before its first target. The ways between, and from and to the upper end of
  /// Z.
  Result<void> connect() {
    std::vector<TrackingLine> reached;
    for (TrackingLine& line : plan_.lines) {
      const Vector3 begin = begin_of(line.plan);
      if (reached.empty()) {
        line.plan.way_in_mm = way_from_above(begin, line.id);
      } else {
        const TrackingLine& last = reached.back();
        const auto transfer = safe_transfer(setup_, begin_of(last.plan), begin);
        if (!transfer) {
          plan_.lost.push_back({line.id, "no safe way to it: " + transfer.error().message});
          continue;
        }
        line.plan.way_in_mm = transfer->over_mm;
        if (!transfer->beam_kept && is_seven(last.id) && is_seven(line.id))
          plan_.remarks.push_back(fmt::format(
              "the beam is lost on the way from {} to {}: its readings begin a new dead path", last.id, line.id));
      }
      reached.push_back(line);
    }
    plan_.lines = std::move(reached);
    TrackingLine& last = plan_.lines.back();
    std::vector<Vector3> out = way_from_above(begin_of(last.plan), last.id);
    std::ranges::reverse(out);
    last.plan.way_out_mm = std::move(out);
    return {};
  }

  std::vector<Vector3> way_from_above(Vector3 place, const std::string& id) {
    if (auto way = tracking::way_from_above(setup_, place)) return *std::move(way);
    plan_.remarks.push_back(fmt::format("{}: there is no way to it from above; drive to X {}, Y {}, Z {} mm by hand",
                                        id, format_fixed(place.x, 3), format_fixed(place.y, 3),
                                        format_fixed(place.z, 3)));
    return {};
  }

  const TrackingSetup& setup_;
  const LinesRequest& request_;
  TrackingPlan plan_;
};

}  // namespace

Result<TrackingPlan> plan_lines(const TrackingSetup& setup, const LinesRequest& request) {
  AXIOMETRY_TRY_VOID(check_setup(setup));
  AXIOMETRY_TRY_VOID(check_request(request));
  AXIOMETRY_TRY(const std::vector<std::string> ids, wanted_ids(setup, request));
  return Planner(setup, request).make(ids);
}

Plan plan_alone(const TrackingSetup& setup, const TrackingLine& line) {
  Plan plan = line.plan;
  if (!spatial_line(plan.axis)) return plan;
  auto way = way_from_above(setup, begin_of(plan));
  if (!way) return plan;
  plan.way_in_mm = *way;
  std::ranges::reverse(*way);
  plan.way_out_mm = *std::move(way);
  return plan;
}

std::optional<UsableInterval> interval_of(const TrackingSetup& setup, const TrackingLine& line) {
  const auto way = spatial_line(line.plan.axis);
  if (!is_seven(line.id) || is_aligned(setup) || !way || line.plan.targets.empty()) return std::nullopt;
  const Vector3 at_target = way->at(line.plan.targets.front()) + setup.tool_offset_mm;
  const double side = dot(at_target - setup.station.position_mm, way->direction);
  Attempt attempt = attempt_line(setup, line.id, side < 0.0 ? -1.0 * way->direction + Vector3{} : way->direction);
  if (attempt.stage != Stage::usable) return std::nullopt;
  return std::move(attempt.interval);
}

Duration estimated_duration(const TrackingPlan& plan) {
  Duration sum;
  std::optional<Vector3> at;
  for (const TrackingLine& line : plan.lines) {
    const Vector3 begin = begin_of(line.plan);
    std::vector<Vector3> stops = line.plan.way_in_mm;
    stops.push_back(begin);
    std::vector<PlannedMove> ways = {{Position{}, std::nullopt}};
    for (const Vector3& stop : stops) {
      const double way = at ? distance(*at, stop) : 0.0;
      ways.push_back({Position::native(ways.back().to.in_native() + way), std::nullopt});
      at = stop;
    }
    for (Duration one : iso230_2::move_durations(ways, line.plan.feed, iso230_2::acceleration_of(line.plan)))
      sum = sum + one;
    sum = sum + iso230_2::estimated_duration(line.plan);
  }
  return sum;
}

}  // namespace axiometry::tracking
