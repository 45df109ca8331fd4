// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/model/plan.h"
#include "axiometry/nc/numbers.h"

/// A rotary axis with rollover (a modulo axis) knows its position within one turn only: an angle says where it shall
/// go and not which way, and many turns are one. Each control has words of its own that say both.
namespace axiometry::nc {

enum class RolloverWords {
  none,        ///< none are needed: the control's rotary axes count on through 0° and 360°
  increments,  ///< distances with a sign: the way is the same however the rollover is set
  directed,    ///< an angle of one turn, and upwards or downwards
};

enum class AxisWay {
  position,   ///< a position to which the control goes by its own rule
  increment,  ///< an increment by which it goes
  short_way,  ///< an angle to which it goes the shorter way
  upwards,    ///< an angle to which it goes upwards, less than a turn
  downwards,
};

/// One word of a move along the axis, in print.
struct TurnWord {
  AxisWay way = AxisWay::position;
  std::string coordinate;
};

/// Spells one plan's positions in their order, each from what was printed for the one before, so that increments add up
/// to what absolute words would be and no rounding is carried on.
class Turn {
 public:
  /// `words` is not `none`; the coordinates are those of a rotary axis.
  Turn(RolloverWords words, const Coordinates& coordinates) : words_(words), coordinates_(coordinates) {}

  /// The way to a position of the plan, °, from that of the last call. One word, or several where it is a turn or
  /// more and `directed` words cannot say so. The first goes to the angle in 0° ≤ x < 360°, by the control's own rule
  /// or the short way: nobody knows where the axis stands.
  std::vector<TurnWord> to(Position position);

  /// Whether the axis stands where `position` would bring it.
  bool is_at(Position position) const { return at_ && *at_ == units(position); }

  /// Decimals of the increments so far, without zeros at their end.
  int decimals_needed() const { return decimals_needed_; }

 private:
  std::int64_t units(Position position) const;  ///< units of the last decimal
  std::string text_of(std::int64_t units) const;

  RolloverWords words_;
  Coordinates coordinates_;
  std::optional<std::int64_t> at_;
  int decimals_needed_ = 0;
};

/// For which axes absolute angles are not. Within one turn, in ways below half of one, they go astray only where the
/// sign of an angle tells the way to it.
std::string rollover_off_remark(const Plan& plan);

}  // namespace axiometry::nc
