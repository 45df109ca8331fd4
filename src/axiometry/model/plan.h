// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/motion_series.h"
#include "axiometry/model/series.h"

/// What shall be measured, before it is: the test programme of clause 5 as a value. standards/iso230_2/plan makes and
/// checks it, formats/plan_json keeps it, nc programs it, capture waits for it, simulation walks it.
namespace axiometry {

/// One approach to a target, at the end of which a reading is taken.
struct Approach {
  std::size_t target = 0;  ///< index i − 1
  Direction direction = Direction::up;
  std::size_t run = 0;  ///< index j − 1

  friend bool operator==(const Approach&, const Approach&) = default;
};

/// The standards and clauses whose terms a plan may use: ISO 230-2, along a diagonal ISO 230-6; no clause where none
/// describes the test.
inline constexpr std::string_view plan_standards[] = {"ISO 230-2:2014", "ISO 230-6:2002"};
inline constexpr std::string_view plan_clauses[] = {"5.3.2", "5.3.3", "5.3.4", "5.3.5", "Annex B", "Annex C", ""};

/// A test programme of one axis, or of one line in space that several axes drive (axis.line_origin_mm, line_direction).
/// A plain value that people may edit; check_sound() says whether it can be walked.
struct Plan {
  std::string standard{plan_standards[0]};
  std::string clause;   ///< "5.3.2", "Annex B"; empty when no clause describes the test
  std::string rule;     ///< id of another rule whose cycle it keeps to as well (standards/rules), "vdi-dgq-3441"
  std::string title;    ///< title of one plan among several: "2 000 mm of the normal working area"
  std::string machine;  ///< name, for comments in programs and the printed sheet; may be empty
  std::string date;     ///< day on which it was made, "2026-11-21"; may be empty
  Axis axis;            ///< name, kind, travel, expected period, sampling points of the compensation
  /// What is to be read at each stop, E of ISO 230-1: EYX, EAX; EXX are the positions. Empty: the positions alone.
  std::vector<MotionName> errors;
  TestCycle cycle = TestCycle::standard;
  std::vector<Position> targets;  ///< P_i, strictly ascending
  std::size_t runs = 5;           ///< n, approaches to each target from each direction the cycle has
  Position overrun;               ///< distance beyond a target before the direction changes, mm or °
  double feed = 0.0;              ///< mm/min or °/min, after the kind of the axis
  /// Of the axis, mm/s² or °/s², where it was stated: how long moves take and where the feed is reached rests on it.
  std::optional<double> acceleration;
  Duration dwell;                     ///< time at rest on every target
  std::size_t warm_up_runs = 0;       ///< there and back over the measurement travel before the first reading
  std::optional<std::uint64_t> seed;  ///< seed of the random part of the targets; absent when they were given
  std::vector<Approach> sequence;     ///< approaches of the user-defined cycle, in order; empty otherwise
  std::vector<Vector3> way_in_mm;     ///< where X, Y, Z are driven before the first move on a line in space, in order
  std::vector<Vector3> way_out_mm;    ///< where they are driven after its last move, in order
  std::vector<Plan> further;          ///< tests that belong to it: the 2 000 mm or 360° test (5.3.3, 5.3.5)
};

/// One positioning command.
struct PlannedMove {
  Position to;
  /// The reading taken there after the dwell; absent on overruns, warm-up and the way back, where nothing waits.
  std::optional<Approach> approach;

  friend bool operator==(const PlannedMove&, const PlannedMove&) = default;
};

/// Fails, naming what is wrong, when the plan cannot be walked: no target, targets not finite or not strictly
/// ascending, |P| beyond 1e9, no run or more than 10 000, an overrun or a feed outside 1e-6 to 1e9, a dwell outside 0
/// to 1e6 s, an acceleration as check_acceleration(), errors of another axis than its own, of a rotary axis, of a line
/// in space or one twice, an invalid line in space (spatial_line()), a way in or out without such a line or beyond 1e9
/// mm, a sequence missing in (or given without) the user-defined cycle, an approach of the sequence that is given twice
/// or names a target or run that does not exist; also when this holds for a further plan. Whether it satisfies the
/// standard is another question (standards/iso230_2/plan/plan.h).
Result<void> check_sound(const Plan& plan);

/// Fails on an acceleration outside 0.001 to 1e6 mm/s² or °/s², on which no duration can be told.
Result<void> check_acceleration(double acceleration);

/// The part of this that is about its errors: straightness and rotations are those of a linear axis that moves alone.
Result<void> check_errors(const Plan& plan);

/// Whether positions of the axis are among what is to be read.
bool measures_positions(const Plan& plan);

/// "EYX, EAX"; "" of a plan of positions alone that does not say so.
std::string errors_text(const Plan& plan);

/// Fails on a plan that is made for other errors alone: what is read at its stops are no positions.
Result<void> check_measures_positions(const Plan& plan);

/// Every reading of the plan in the order in which it is taken. Needs a sound plan.
///
/// - standard (Figure 1): run by run, ↑ over all targets, then ↓ over all.
/// - step (Annex B): target by target, run by run ↑ and ↓ in turn.
/// - pilgrim: target by target, all runs ↑; then from the last target to the first, all runs ↓.
/// - unidirectional: run by run, ↑ over all targets.
/// - user-defined: `sequence`.
std::vector<Approach> approaches(const Plan& plan);

/// Every positioning command of the plan, in order: warm-up, approaches, and the overruns that make each approach come
/// from its direction. Needs a sound plan. The first command goes to the overrun before the first target (from wherever
/// the axis stands), the last to where it began. Before an approach ↑ the axis is at most at P_i − overrun, unless it
/// comes straight from a lower target of the same pass; likewise ↓. No command is given where the axis is already.
std::vector<PlannedMove> moves(const Plan& plan);

/// Lowest and highest position that moves() reaches: P_1 − overrun and P_m + overrun. Needs a sound plan.
struct Reach {
  Position lowest;
  Position highest;
};
Reach reach(const Plan& plan);

/// "standard", "step", "pilgrim", "unidirectional", "user-defined".
std::string_view cycle_name(TestCycle cycle);

/// What must stand wherever results of such a test do: "step cycle (Annex B), not for acceptance"; "" for the standard
/// test cycle.
std::string_view cycle_label(TestCycle cycle);

}  // namespace axiometry
