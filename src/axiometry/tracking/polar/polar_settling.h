// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/tracking/polar/polar_reduction.h"

/// The way from a start to the least squares. Internal to adjust_polar().
namespace axiometry::tracking::detail {

enum class PolarOutcome {
  settled,     ///< or cannot come closer in doubles
  unsettled,   ///< after as many iterations as were asked for
  diverged,    ///< χ² is beyond all numbers
  not_wanted,  ///< `stop` was asked for
};

/// Where it came to.
struct PolarSettling {
  PolarOutcome outcome = PolarOutcome::unsettled;
  PolarState state;
  PolarSystem system;
  PolarInverse inverse;
  std::size_t iterations = 0;
  double move_mm = 0.0;  ///< by which the last step moved a point or a station at most
};

/// Gauss and Newton, damped as by Levenberg and Marquardt in units of the columns where a step makes χ² larger or
/// something is undetermined. Settled where a step moves all by 1e-7 mm at most, or would lower χ² by 1e-12 of the
/// number of unknowns: by 1e-6 of their uncertainties.
PolarSettling settle_polar(const PolarLayout& layout, std::span<const PolarReading> readings, PolarState start,
                           const PolarOptions& options);

}  // namespace axiometry::tracking::detail
