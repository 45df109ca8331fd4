// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/predict_targets.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::app {

using volumetric::MeasuredMeans;

Result<TargetsOfFile> targets_of_plan(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  AXIOMETRY_TRY(const Plan plan, in_file(formats::read_plan(bytes), file));
  TargetsOfFile targets{.positions_mm = {}, .line = spatial_line(plan.axis), .axis_name = plan.axis.name};
  for (const Position p : plan.targets) targets.positions_mm.push_back(p.in_native());
  return targets;
}

Result<TargetsOfFile> targets_of_test(const std::string& file) {
  AXIOMETRY_TRY(const Test test, read_test(file));
  if (test.metadata.axis.kind != AxisKind::linear)
    return in_file(Result<TargetsOfFile>(fail("found a test of a rotary axis, expected one of a linear axis")), file);
  TargetsOfFile targets{.positions_mm = {}, .line = spatial_line(test.metadata.axis), .means = MeasuredMeans{}};
  const auto positions = iso230_2::evaluate_positions(test.series);
  const bool up = test.series.has(Direction::up), down = test.series.has(Direction::down);
  targets.axis_name = test.metadata.axis.name;
  if (const auto& offset = test.metadata.conditions.tool_offset_mm; offset.size() == 3)
    targets.offset_mm = Vector3{offset[0], offset[1], offset[2]};
  targets.means->both_directions = up && down;
  targets.means->direction = up ? Direction::up : Direction::down;
  // Runs that lie apart leave the shape alone; of their slopes, where they have some of their own, the mean counts.
  const Series series = without_empty_runs(test.series);
  const iso230_2::TiltStudy tilts = iso230_2::tilt_study(series);
  const bool tilted = tilts.p <= iso230_2::tilt_counts_level;
  const auto directions = static_cast<double>(up) + static_cast<double>(down);
  double squares = 0.0, freedom = 0.0;
  for (const auto& p :
       iso230_2::evaluate_positions(iso230_2::without_shifts(tilted ? iso230_2::without_tilts(series) : series)))
    for (const auto& [s, n] : {std::pair{p.s_up, p.count_up}, std::pair{p.s_down, p.count_down}})
      if (s) {
        squares += static_cast<double>(n - 1) * s->in_native() * s->in_native();
        freedom += static_cast<double>(n - 1);
      }
  if (freedom == 0.0)
    return in_file(
        Result<TargetsOfFile>(fail("found a test of one run, whose scatter is not known, expected two runs or "
                                   "more to hold against a prediction")),
        file);
  const auto runs = static_cast<double>(series.run_count());
  const double of_runs = (tilted ? 2.0 : 1.0) * directions * (runs - 1.0);  // level and slope of each but one
  targets.means->degrees_of_freedom = std::max(1.0, freedom - of_runs);
  const double s = std::sqrt(squares / targets.means->degrees_of_freedom);  // pooled
  if (tilted) {
    targets.means->slope_u_um_per_mm = tilts.u_of_mean() / series.travel_native();
    targets.means->slope_degrees_of_freedom = tilts.degrees();
  }
  for (const auto& p : positions) {
    if ((up && !p.mean_up) || (down && !p.mean_down)) continue;
    targets.positions_mm.push_back(p.target.in_native());
    const double once = up && down ? 1.0 : std::sqrt(2.0);  // their mean is else the one there is
    const auto u = [&](std::size_t n) {
      return once * s / std::sqrt(static_cast<double>(std::max<std::size_t>(n, 1)));
    };
    targets.means->up_um.push_back((up ? p.mean_up : p.mean_down)->in_native());
    targets.means->down_um.push_back((down ? p.mean_down : p.mean_up)->in_native());
    targets.means->up_u_um.push_back(u(up ? p.count_up : p.count_down));
    targets.means->down_u_um.push_back(u(down ? p.count_down : p.count_up));
  }
  return targets;
}

}  // namespace axiometry::app
