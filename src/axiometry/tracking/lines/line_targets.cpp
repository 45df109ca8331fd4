// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lines/line_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/iso230_2/programme.h"
#include "axiometry/standards/iso230_6.h"
#include "axiometry/tracking/geometry/machine_axes.h"

namespace axiometry::tracking {
namespace {

constexpr double off_the_line = 0.25;  // distance across the line, in steps
constexpr int most_steps = 100;        // steps along the line in the search for a place
constexpr std::size_t runs_of_line = 5;

/// k/1000, not k·0.001, is the double that "12.345" reads as.
double rounded(double x, double step) {
  const double per_unit = std::round(1.0 / step);
  const bool decimal = per_unit >= 1.0 && std::abs(per_unit * step - 1.0) < 1e-9;
  return decimal ? std::round(x * per_unit) / per_unit : std::round(x / step) * step;
}

Vector3 rounded(Vector3 v, double step) { return {rounded(v.x, step), rounded(v.y, step), rounded(v.z, step)}; }

std::size_t first_moving(Vector3 direction) { return axis_moves(direction, 0) ? 0 : axis_moves(direction, 1) ? 1 : 2; }

/// Positions between which the axes are in their travels.
iso230_2::Stretch within_travels(const TravelBox& travel, const SpatialLine& line) {
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!axis_moves(line.direction, k)) continue;
    const double a = (travel.lowest_mm[k] - line.origin_mm[k]) / line.direction[k];
    const double b = (travel.highest_mm[k] - line.origin_mm[k]) / line.direction[k];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return {Position::native(low), Position::native(high)};
}

std::string coordinates_text(Vector3 at_mm) {
  return fmt::format("X {}, Y {}, Z {} mm", format_fixed(at_mm.x, 3), format_fixed(at_mm.y, 3),
                     format_fixed(at_mm.z, 3));
}

std::string axis_name(std::string_view id) {
  std::string name;
  for (char c : id) name += c >= 'x' && c <= 'z' ? static_cast<char>(c - 'x' + 'X') : c;
  return name;
}

/// A place beside the line, and what of the way to it is across the line, in steps.
struct GridPlace {
  double position = 0.0;
  double across = 0.0;
};

GridPlace grid_place(const SpatialLine& line, double position, double step) {
  const Vector3 off = rounded(line.at(Position::native(position)), step) - line.at(Position::native(position));
  const double along = dot(off, line.direction);
  const Vector3 across = off - along * line.direction;
  return {position + along, std::max({std::abs(across.x), std::abs(across.y), std::abs(across.z)}) / step};
}

}  // namespace

LineTask task_of(const TrackingSetup& setup, const UsableInterval& interval, double step_mm) {
  const Vector3 at_station = setup.station.position_mm - setup.tool_offset_mm;
  const Vector3 origin = rounded(at_station, step_mm);
  const std::size_t first = first_moving(interval.direction);
  const double sign = interval.direction[first] > 0.0 ? 1.0 : -1.0;
  LineTask task{.id = interval.id,
                .line = {origin, sign * interval.direction + Vector3{}},
                .measurement_line = "through the station at " + coordinates_text(setup.station.position_mm),
                .octant = interval.octant};
  double from = sign * interval.begin_mm, to = sign * interval.end_mm;
  if (interval.id.size() == 1) {
    task.line.origin_mm[first] = 0.0;
    task.line.direction[first] = 1.0;
    from += at_station[first];
    to += at_station[first];
  } else if (const double moved = distance(origin, at_station); moved > 1e-9) {
    // The interval is that of the line through the station itself; the one driven is half a step beside it.
    from += (from < to ? 2.0 : -2.0) * moved;
    to -= (from < to ? 2.0 : -2.0) * moved;
  }
  task.usable = {Position::native(std::min(from, to)), Position::native(std::max(from, to))};
  task.travel = within_travels(setup.travel, task.line);
  return task;
}

LineTask diagonal_task(const TrackingSetup& setup, const std::string& id, Vector3 begin_mm, Vector3 end_mm,
                       double step_mm) {
  LineTask task{.id = id,
                .line = {rounded(begin_mm, step_mm), unit(end_mm - begin_mm)},
                .measurement_line = "diagonal of the travels from " + coordinates_text(begin_mm),
                .octant = {}};
  task.travel = within_travels(setup.travel, task.line);
  task.usable = task.travel;
  return task;
}

std::optional<Position> period_along(Vector3 direction, const std::array<std::optional<Position>, 3>& periods) {
  std::optional<Position> longest;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!axis_moves(direction, k) || !periods[k]) continue;
    const Position along = Position::native(periods[k]->in_native() / std::abs(direction[k]));
    longest = longest ? std::max(*longest, along) : along;
  }
  return longest;
}

Position on_grid(const SpatialLine& line, Position position, double step_mm, Towards towards) {
  GridPlace best{position.in_native(), std::numeric_limits<double>::infinity()};
  for (int k = 0; k <= most_steps; ++k)
    for (double sign : {1.0, -1.0}) {
      if ((k == 0 && sign < 0.0) || (towards == Towards::higher && sign < 0.0) ||
          (towards == Towards::lower && sign > 0.0 && k > 0))
        continue;
      const GridPlace place = grid_place(line, position.in_native() + sign * k * step_mm, step_mm);
      const double moved = place.position - position.in_native();
      if ((towards == Towards::higher && moved < 0.0) || (towards == Towards::lower && moved > 0.0)) continue;
      if (place.across < best.across) best = place;
      if (best.across <= off_the_line) return Position::native(best.position);
    }
  return Position::native(best.position);
}

Result<TrackingLine> planned_line(const LineTask& task, const LinesRequest& request) {
  iso230_2::PlanRequest wanted;
  wanted.axis.name = axis_name(task.id);
  wanted.axis.travel_begin = task.travel.from;
  wanted.axis.travel_end = task.travel.to;
  wanted.axis.measurement_line = task.measurement_line;
  wanted.axis.expected_period = period_along(task.line.direction, request.periods);
  set_spatial_line(wanted.axis, task.line);
  wanted.machine = request.machine;
  wanted.date = request.date;
  wanted.soft_limits = task.usable;
  wanted.count = request.count;
  wanted.runs = request.runs.value_or(runs_of_line);
  wanted.overrun = request.overrun;
  wanted.feed = request.feed;
  wanted.dwell = request.dwell;
  wanted.acceleration = request.acceleration;
  wanted.warm_up_runs = request.warm_up_runs;
  wanted.step = Position::native(request.step_mm);
  wanted.seed = task.seed;
  using iso230_2::Programme;
  if (!wanted.count &&
      iso230_2::programme_of(AxisKind::linear, Position::native(task.usable.length())) == Programme::long_linear)
    wanted.count = iso230_2::required_targets(Programme::short_linear, Position::native(task.usable.length())).count;
  AXIOMETRY_TRY(Plan plan, iso230_2::make_plan(wanted));
  plan.further.clear();  // five runs over the whole hold what they would ask
  plan.title = task.octant.empty() ? fmt::format("Diagonal {}", task.id)
                                   : fmt::format("Line {}, octant {}", task.id, task.octant);
  if (moving_axes(task.line) > 1) {
    plan.standard = iso230_6::edition;
    plan.clause.clear();
    const std::size_t last = plan.targets.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
      plan.targets[i] = on_grid(task.line, plan.targets[i], request.step_mm,
                                i == 0      ? Towards::higher
                                : i == last ? Towards::lower
                                            : Towards::either);
  }
  AXIOMETRY_TRY_VOID(check_sound(plan));
  return TrackingLine{task.id, std::move(plan)};
}

}  // namespace axiometry::tracking
