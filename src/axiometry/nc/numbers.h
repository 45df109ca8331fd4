// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/nc/dialect.h"

/// Numbers of part programs: fixed decimals, a decimal point, never "-0".
namespace axiometry::nc {

constexpr double mm_per_inch = 25.4;

/// Most decimals of a coordinate: 1 nm, 12.7 nm in inches (half of it is the largest error).
constexpr int decimals_highest = 6;

/// Coordinates of one axis in the unit of the program. Angles are in degrees whatever that is.
class Coordinates {
 public:
  /// The unit of `options`, and at least its decimals: more as the targets need them, at most decimals_highest. Fails
  /// when the options ask for fewer than 0 or more than that, when two targets would be the same in print, or the
  /// overrun is less than two units of the last decimal.
  static Result<Coordinates> make(const Plan& plan, const ProgramOptions& options);

  int decimals() const { return decimals_; }
  bool in_inch() const { return in_inch_; }

  /// "-12.5000"; "12." without decimals.
  std::string text(Position position) const;

  /// Largest distance, mm or °, between a target and what is printed for it.
  Position target_error(const Plan& plan) const;

 private:
  Coordinates(bool in_inch, int decimals) : in_inch_(in_inch), decimals_(decimals) {}

  bool in_inch_ = false;
  int decimals_ = 4;
};

/// Rounded to at most `decimals` decimals, without the zeros at their end, and without a point when none are left:
/// "1000", "39.3701".
std::string trimmed_number(double x, int decimals);

}  // namespace axiometry::nc
