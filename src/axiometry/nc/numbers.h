// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/nc/dialect.h"

/// Numbers of part programs: fixed decimals, a decimal point, never "-0".
namespace axiometry::nc {

constexpr double mm_per_inch = 25.4;

/// Most decimals of a coordinate: 1 nm, 12.7 nm in inches (half of it is the largest error).
constexpr int decimals_highest = 6;

/// Whether the axis X, Y or Z (k = 0, 1, 2) moves along the line, as moving_axes() counts.
bool moves_along(const SpatialLine& line, std::size_t k);

/// Coordinates of one plan, in the unit of the program. Angles are in degrees whatever that is.
class Coordinates {
 public:
  /// The unit of `options`, and at least its decimals: more as the targets need them, at most decimals_highest.
  /// - In mm and degrees a target is exact; in inches right within 0.05 µm.
  /// - On a line in space each coordinate is right within 0.05 µm, since a slanting line has targets that no number of
  ///   decimals tells exactly. Where one axis alone moves, its own coordinate is exact as above.
  /// - Ways and overruns have the decimals of the targets; on a line in space, where they keep a safe radius and stay
  ///   within the travels, each coordinate is right within half of 0.001 mm, in inches of 0.0001 in.
  ///
  /// Fails when the options ask for fewer than 0 decimals or too many, when two targets would be the same in print, or
  /// the overrun is less than two units of the last decimal.
  static Result<Coordinates> make(const Plan& plan, const ProgramOptions& options);

  /// Of places in space: each coordinate right within 0.05 µm, with at least the decimals of `options`. Fails on
  /// decimals that are none.
  static Result<Coordinates> of_points(std::span<const Vector3> points_mm, const ProgramOptions& options);

  int decimals() const { return decimals_; }
  /// What fewer decimals, where they were asked for, would move: "TARGETS" or "WAYS".
  std::string_view moved() const { return moved_; }
  bool in_inch() const { return in_inch_; }
  /// Behind a coordinate that a person reads: a control shows mm unless told otherwise.
  std::string_view unit_word() const { return in_inch_ ? " INCH" : ""; }

  /// A coordinate of one axis in mm or degrees, as it is printed: "-12.5000"; "12." without decimals.
  std::string text(double mm_or_deg) const;

  /// Largest distance, mm or °, between a target and what is printed for it; in space that of the two points.
  Position target_error(const Plan& plan) const;

 private:
  Coordinates(bool in_inch, int decimals) : in_inch_(in_inch), decimals_(decimals) {}

  double printed(double mm_or_deg) const;
  Vector3 printed(Vector3 mm) const;
  bool targets_right(const Plan& plan, const std::optional<SpatialLine>& line) const;
  bool ways_right(const Plan& plan, const std::optional<SpatialLine>& line) const;
  bool told_apart(const Plan& plan, const std::optional<SpatialLine>& line) const;

  bool in_inch_ = false;
  int decimals_ = 4;
  std::string_view moved_ = "WAYS";
};

/// Rounded to at most `decimals` decimals, without the zeros at their end, and without a point when none are left:
/// "1000", "39.3701".
std::string trimmed_number(double x, int decimals);

}  // namespace axiometry::nc
