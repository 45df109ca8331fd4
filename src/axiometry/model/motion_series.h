// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/series.h"

/// Readings of an error of an axis other than that of its positions: how far it strays across its way (straightness)
/// or turns on it (roll, pitch, yaw).
namespace axiometry {

enum class MotionUnit { um, urad, arcsec };

std::string_view motion_unit_name(MotionUnit unit);    ///< "um", "urad", "arcsec"
std::string_view motion_unit_symbol(MotionUnit unit);  ///< "µm", "µrad", "″"
inline bool is_angle(MotionUnit unit) { return unit != MotionUnit::um; }

/// An error motion by its name of ISO 230-1: E, the coordinate in which it is, the axis that moves. EYX is the
/// straightness of X in the direction of Y, EAX, EBX and ECX are the rotations of X about X, Y and Z.
struct MotionName {
  char coordinate = 'Y';  ///< X, Y, Z: a displacement; A, B, C: a rotation about X, Y, Z
  char axis = 'X';        ///< X, Y or Z

  bool rotation() const { return coordinate >= 'A' && coordinate <= 'C'; }
  bool straightness() const { return !rotation() && coordinate != axis; }
  bool roll() const { return rotation() && coordinate - 'A' == axis - 'X'; }
  std::string text() const { return {'E', coordinate, axis}; }

  friend bool operator==(const MotionName&, const MotionName&) = default;
};

/// Of "EYX" in any case. Fails on all but the 18 names of three linear axes.
Result<MotionName> motion_name(std::string_view text);

/// Which way a reading is positive, in axes of the machine: towards +Y or −Y of a displacement; of a rotation +A by the
/// right-hand rule about X, −A against it.
struct ReadingSense {
  char coordinate = 'Y';  ///< X, Y or Z, as the coordinate of a MotionName
  bool negative = false;

  std::string text() const { return {negative ? '-' : '+', coordinate}; }

  friend bool operator==(const ReadingSense&, const ReadingSense&) = default;
};

/// Of "+Y", "-A" in any case, the sign written as hyphen or minus. Fails on all else: a sign that is not written is not
/// guessed.
Result<ReadingSense> reading_sense(std::string_view text);

struct MotionReading {
  double position_mm = 0.0;
  Direction direction = Direction::up;
  std::size_t run = 1;  ///< number of the run, as the file counts
  double value = 0.0;   ///< deviation in the unit of the series
  TextPosition at{};    ///< place in the file where it stands
};

/// Readings of all runs at all positions, none left out and none twice.
class MotionSeries {
 public:
  /// Fails, with the place where there is one, on a position in one run and direction twice, on one that another run or
  /// direction has and this lacks, on fewer than `positions_least` different positions, on positions within 1 nm, on
  /// readings that are not finite or above 1e9, positions above 1e9 mm. O(n log n) for n readings.
  static Result<MotionSeries> make(std::vector<MotionReading> readings, MotionUnit unit, std::size_t positions_least);

  MotionUnit unit() const { return unit_; }
  const std::vector<double>& positions_mm() const { return positions_mm_; }          ///< ascending
  const std::vector<Direction>& directions() const { return directions_; }           ///< one, or ↑ and ↓
  std::size_t runs() const { return runs_; }                                         ///< the same in each direction
  double travel_mm() const { return positions_mm_.back() - positions_mm_.front(); }  ///< > 0

  /// Index of the direction in directions(), of the run by its number, of the position.
  double value(std::size_t direction, std::size_t run, std::size_t position) const {
    return values_[(direction * runs_ + run) * positions_mm_.size() + position];
  }

 private:
  MotionUnit unit_ = MotionUnit::um;
  std::vector<double> positions_mm_;
  std::vector<Direction> directions_;
  std::size_t runs_ = 0;
  std::vector<double> values_;
};

}  // namespace axiometry
