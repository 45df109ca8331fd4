// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/trigger.h"
#include "axiometry/nc/turn.h"
#include "axiometry/nc/work_frame.h"

/// What every part program of one or several plans has, before it is spelled for one control: numbers are rounded and
/// printed here, so that all dialects do it alike.
namespace axiometry::nc {

/// What a control can be told at all.
struct ControlLimits {
  std::string_view linear_axes = "X Y Z U V W";
  std::string_view rotary_axes = "A B C";
  bool numbered_axes = false;                        ///< whether a number may follow the letter: "X1"
  Position farthest = Position::native(99'999.999);  ///< magnitude of a coordinate, mm or °
  double feed_highest = 240'000.0;                   ///< mm/min or °/min
  int feed_decimals = 3;
  double feed_per_inch = 1.0;  ///< what 1 inch/min is written as; 10 where the unit is a tenth of an inch
  Duration dwell_step = Duration::s(0.001);
  Duration dwell_longest = Duration::s(9'999.0);
  bool dwell_stops = false;  ///< whether only a dwell, be it of 0 s, makes the axis come to rest
  std::size_t loops = 0;     ///< how many a program may have
  TriggerCodes m_codes = {{coolant}};
  FrameWords frames = {};
  RolloverWords rollover = RolloverWords::increments;
};

/// Only a comment.
struct Remark {
  std::string text;
};
/// Where an axis goes.
struct AxisWord {
  std::string axis;        ///< name in capitals
  std::string coordinate;  ///< "-12.5000", with a decimal point
  AxisWay way = AxisWay::position;
};
/// To a position, straight and with all axes at once, at a feed along the path.
struct Move {
  std::vector<AxisWord> axes;
  std::string feed;  ///< number without a decimal point when it is whole
  std::string remark;
};
struct Dwell {
  long steps = 0;  ///< duration in ControlLimits::dwell_step
};
struct Trigger {
  unsigned m_code = 0;
};
/// Until the operator starts again.
struct OperatorStop {
  std::string message;
};
struct LoopBegin {
  std::size_t number = 1;  ///< 1, 2, … in the program, over all its plans
  std::size_t times = 1;
};
struct LoopEnd {
  std::size_t number = 1;
  std::size_t times = 1;
};
using Instruction = std::variant<Remark, Move, Dwell, Trigger, OperatorStop, LoopBegin, LoopEnd>;

struct Script {
  std::vector<std::string> heading;  ///< comments before everything else
  WorkFrame frame;
  bool inch = false;
  bool has_loops = false;
  std::vector<Instruction> instructions;
};

/// The plans in their order. One with a line in space begins with its way in, by moves of X, Y and Z, goes to the first
/// overrun on the line with all three, then names the axes that move on the line in every move, and ends with its way
/// out. Another one names its axis. Numbers of loops and their limit go over all plans.
///
/// Coordinates have as many decimals as the options say, and up to 6 where the targets of the plan need them
/// (Coordinates::make()). A dwell is rounded up to the control's step. With rollover the words of a rotary axis are
/// those of Turn, and a loop begins where its first time leaves the axis.
///
/// Fails on no plan, on several of which one has no line in space, on an axis that the control cannot name, a number of
/// decimals beyond 0 to 6, positions that cannot be told apart with 6, a position, a feed or a dwell beyond the
/// control's range, an M code that is no trigger, a frame that the control has not, and rollover of an axis that is not
/// rotary or of a control that needs no words for it. Needs sound plans.
Result<Script> make_script(std::span<const Plan> plans, const ProgramOptions& options, const ControlLimits& limits);

/// A tour: its heading, then its stops in order, at each reading a dwell and the trigger, which ends with the dwell.
/// With stop_at_start the operator sets the instrument at the first reading; where the beam was lost he finds it again.
/// Coordinates are right within 0.05 µm in mm and inches. Fails on no reading and as above.
Result<Script> make_script(const PointTour& tour, const ProgramOptions& options, const ControlLimits& limits);

/// Of a program of one plan. "DWELL 3 S" and the like: what stands at its top, one comment each.
/// `frame` says what its positions are.
std::vector<std::string> headlines(const Plan& plan, const ProgramOptions& options, std::string_view frame);

/// Of a program of several plans, each a line in space, what is true of all of them: how many, and between which
/// coordinates each axis moves.
std::vector<std::string> headlines(std::span<const Plan> lines, const ProgramOptions& options, std::string_view frame);

/// What stands before one of them.
std::vector<std::string> line_headlines(const Plan& line);

/// "XY", or what else the plan's line is called; "THE LINE" when it has no name.
std::string line_name(const Plan& line);

}  // namespace axiometry::nc
