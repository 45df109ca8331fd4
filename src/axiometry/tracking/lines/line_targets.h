// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/tracking/lines/seven_lines.h"

/// From a usable interval to a plan of it. Private to tracking/.
namespace axiometry::tracking {

/// A line as it is to be driven, before its targets are chosen.
struct LineTask {
  std::string id;
  SpatialLine line;              ///< line of the axes; position as TrackingLine says
  iso230_2::Stretch usable{};    ///< positions; overruns included
  iso230_2::Stretch travel{};    ///< positions that the travels allow
  std::string measurement_line;  ///< words for people
  std::string octant;            ///< "+0−"; empty for diagonals of the box
  std::uint64_t seed = 0;
};

/// Of one of the seven lines: its origin on the step's grid where an axis rests or where all move alike.
LineTask task_of(const TrackingSetup& setup, const UsableInterval& interval, double step_mm);

/// Of a diagonal of the box, over its full length.
LineTask diagonal_task(const TrackingSetup& setup, const std::string& id, Vector3 begin_mm, Vector3 end_mm,
                       double step_mm);

/// Period of the line from those of the axes: the largest p_a/|u_a|; absent where none of the axes that move has one.
std::optional<Position> period_along(Vector3 direction, const std::array<std::optional<Position>, 3>& periods);

/// Which way a position may be moved to meet the grid.
enum class Towards { either, higher, lower };

/// The position nearest to this whose coordinates are within a quarter of a step of multiples of it, across the line
/// alone; where there is none within 100 steps, the best of these.
Position on_grid(const SpatialLine& line, Position position, double step_mm, Towards towards);

/// Fails as make_plan() does.
Result<TrackingLine> planned_line(const LineTask& task, const LinesRequest& request);

}  // namespace axiometry::tracking
