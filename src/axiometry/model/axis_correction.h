// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/series.h"

namespace axiometry {

/// What a control's table can hold.
enum class TableCurves {
  both_ways,      ///< one curve, whatever the direction of approach
  with_backlash,  ///< one curve, and one number more in the negative direction
  each_way,       ///< a curve for each direction
};
std::string_view curves_name(TableCurves curves);  ///< "both-ways", "with-backlash", "each-way"

/// What a control adds to the position that is commanded of one axis, from its table of compensation: linear between
/// the positions, constant beyond the ends. One sign throughout: a positive value moves the axis in the positive
/// direction, by so many µm (″ on a rotary axis); each control's own sign is the business of its format.
class AxisCorrection {
 public:
  /// Fails without a position, on lists of different lengths, positions that do not ascend, a number that is none, and
  /// a value beyond `largest_um`.
  static Result<AxisCorrection> make(AxisKind kind, std::vector<double> positions, std::vector<double> up,
                                     std::vector<double> down);

  /// Larger errors of an axis are no matter of compensation: 10 mm, or 2.8°.
  static constexpr double largest_um = 10'000.0;
  static constexpr std::size_t nodes_max = 20'000;

  AxisKind kind() const { return kind_; }
  const std::vector<double>& positions() const { return positions_; }  ///< mm or °, ascending
  const std::vector<double>& values(Direction direction) const { return direction == Direction::up ? up_ : down_; }
  bool same_both_ways() const { return up_ == down_; }

  /// Added where `position` is commanded and was approached so.
  double at(double position, Direction direction) const;

 private:
  AxisCorrection(AxisKind kind, std::vector<double> positions, std::vector<double> up, std::vector<double> down)
      : kind_(kind), positions_(std::move(positions)), up_(std::move(up)), down_(std::move(down)) {}

  AxisKind kind_;
  std::vector<double> positions_, up_, down_;
};

}  // namespace axiometry
