// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/nc/dialect.h"

/// What every part program of a plan has, before it is spelled for one control: numbers are rounded and printed here,
/// so that all dialects do it alike.
namespace axiometry::nc {

/// From `first` to `last`; none when `last` is less.
struct MCodes {
  unsigned first = 1;
  unsigned last = 0;
};

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
  bool dwell_stops = false;                      ///< whether only a dwell, be it of 0 s, makes the axis come to rest
  std::size_t loops = 0;                         ///< how many a program may have
  std::array<MCodes, 2> m_codes = {{{0, 999}}};  ///< there are, for the trigger
};

/// Only a comment.
struct Remark {
  std::string text;
};
/// To a position at the feed of the program.
struct Move {
  std::string coordinate;  ///< "-12.5000", with a decimal point
  std::string remark;
};
struct Dwell {
  long steps = 0;  ///< of ControlLimits::dwell_step
};
struct Trigger {
  unsigned m_code = 0;
};
/// Until the operator starts again.
struct OperatorStop {
  std::string message;
};
struct LoopBegin {
  std::size_t number = 1;  ///< 1, 2, … in the program
  std::size_t times = 1;
};
struct LoopEnd {
  std::size_t number = 1;
  std::size_t times = 1;
};
using Instruction = std::variant<Remark, Move, Dwell, Trigger, OperatorStop, LoopBegin, LoopEnd>;

struct Script {
  std::string axis;  ///< in capitals
  std::string feed;  ///< without a decimal point when it is a whole number
  bool inch = false;
  bool has_loops = false;
  std::vector<Instruction> instructions;
};

/// Coordinates have as many decimals as the options say, and up to 6 where the targets need them: in mm and degrees
/// until each is exact, in inches until each is right within 0.05 µm. A dwell is rounded up to the control's step.
///
/// Fails on an axis that the control cannot name, a number of decimals beyond 0 to 6, positions that cannot be told
/// apart with 6, a position, a feed or a dwell beyond the control's range, an M code that is none of the control's,
/// ends the program or moves spindle or tool. Needs a sound plan.
Result<Script> make_script(const Plan& plan, const ProgramOptions& options, const ControlLimits& limits);

/// "DWELL 3 S" and the like: what stands at the top of the program, one comment each.
std::vector<std::string> headlines(const Plan& plan, const ProgramOptions& options);

}  // namespace axiometry::nc
