// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/vector3.h"

namespace axiometry {

enum class AxisKind { linear, rotary };

/// Coordinate along or around an axis: mm on a linear axis, ° on a rotary one. A class of its own,
/// because the formulas of ISO 230-2 are the same for both and only the edges know the unit.
class Position {
 public:
  constexpr Position() = default;
  /// Millimetres or degrees, after the kind of the axis.
  static constexpr Position native(double mm_or_deg) { return Position(mm_or_deg); }
  constexpr double in_native() const { return value_; }
  friend constexpr auto operator<=>(Position, Position) = default;

 private:
  constexpr explicit Position(double value) : value_(value) {}
  double value_ = 0.0;
};

/// Positioning deviation x_ij (3.6) and everything computed from it: µm on a linear axis, ″ on a
/// rotary one.
class Deviation {
 public:
  constexpr Deviation() = default;
  /// Micrometres or seconds of arc, after the kind of the axis.
  static constexpr Deviation native(double um_or_arcsec) { return Deviation(um_or_arcsec); }
  constexpr double in_native() const { return value_; }
  friend constexpr auto operator<=>(Deviation, Deviation) = default;

 private:
  constexpr explicit Deviation(double value) : value_(value) {}
  double value_ = 0.0;
};

/// "mm" or "°".
std::string_view position_unit(AxisKind kind);
/// "µm" or "″".
std::string_view deviation_unit(AxisKind kind);
/// "um" or "arcsec", as files and programs spell it.
std::string_view deviation_unit_key(AxisKind kind);
/// "linear" or "rotary".
std::string_view axis_kind_name(AxisKind kind);
/// How many deviation units one position unit has: 1000 (µm in a mm) or 3600 (″ in a °).
constexpr double deviation_per_position(AxisKind kind) { return kind == AxisKind::linear ? 1000.0 : 3600.0; }

/// The axis under test, as clause 8.1 wants it identified.
struct Axis {
  std::string name;  ///< "X"; empty when the source does not tell
  AxisKind kind = AxisKind::linear;
  std::optional<Position> travel_begin;  ///< axis travel (3.1), where it has limits
  std::optional<Position> travel_end;
  std::string measurement_line;  ///< linear: where it lies; rotary: position and orientation
  std::string scale_type;        ///< "ball screw and rotary encoder", "linear scale", …
  std::optional<ExpansionCoefficient> scale_expansion;
  std::string compensation;                 ///< built-in compensation during the test; "none" is an answer
  std::vector<double> compensation_points;  ///< sampling points (3.28), mm or °
  std::optional<Position> expected_period;  ///< period of an error (5.2, Annex C): pitch of screw or scale, mm or °
  std::vector<double> line_origin_mm;  ///< where X, Y, Z stand at position 0 of a line in space, as given; else empty
  std::vector<double> line_direction;  ///< direction of a line in space in which position grows, as given
};

/// Whether a control may have corrected the axis while it was measured, as `compensation` and its sampling points tell:
/// not where nothing is stated, nor where it is stated that there was none ("none", "not used", "keine", "aucune").
bool may_be_compensated(const Axis& axis);

/// Whether it says that none was.
bool states_no_compensation(const Axis& axis);

/// A straight line in space that the linear axes X, Y, Z drive together, or one of them alone at a known place: at
/// position P they stand at origin_mm + P·direction.
struct SpatialLine {
  Vector3 origin_mm;
  Vector3 direction;  ///< unit vector

  Vector3 at(Position position) const { return origin_mm + position.in_native() * direction; }
};

/// The line of an axis; absent when it has none, or what was given is none: not three finite numbers each, a direction
/// shorter than 1e-9 or longer than 1e9, an origin beyond 1e9 mm, a rotary axis.
std::optional<SpatialLine> spatial_line(const Axis& axis);

/// Gives the axis this line.
void set_spatial_line(Axis& axis, const SpatialLine& line);

/// The ends of the axis travel (3.1), in whichever order they were stated: a machine may count from 0 down to −500.
struct AxisEnds {
  std::optional<Position> lower;
  std::optional<Position> upper;

  std::optional<double> length_native() const;  ///< absent where an end is
};
AxisEnds axis_ends(const Axis& axis);

/// How many of the axes X, Y, Z move along the line: components of the direction above 1e-9.
std::size_t moving_axes(const SpatialLine& line);

/// Whether several axes move at once, which is a test after ISO 230-6 and not after ISO 230-2.
bool is_diagonal(const Axis& axis);

}  // namespace axiometry
