// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/base/result.h"
#include "axiometry/standards/error_motions/axis_motion.h"

/// The squareness of two axes from the straightness of each, measured against one optical square.
///
///     θ = atan b of each line,  S = θ_2 − θ_1 + error of the optical square
///
/// always in this order: the other order of the files gives θ_1 − θ_2. The slopes are those of the mean of both
/// directions, or of the one there is; both by the same reference.
///
/// Uncertainty: of each slope as axis_motion.h has it; the scatter of the two lines is independent. What the instrument
/// adds to both may be common, with either sign, and counts as the sum of both (at most that, whatever the
/// correlation). The square adds its own.
namespace axiometry::error_motions {

struct SquarenessOptions {
  std::optional<double> square_error_arcsec{};        ///< error of the optical square; nothing stated counts as 0
  std::optional<double> square_uncertainty_arcsec{};  ///< expanded, k = 2, of that error
};

struct MeasuredSquareness {
  MotionEstimate theta_1_arcsec, theta_2_arcsec;
  MotionEstimate squareness_arcsec;  ///< S
};

/// Fails where the readings are no straightness, or the two lines have different references or none.
Result<MeasuredSquareness> measured_squareness(const AxisMotion& first, const AxisMotion& second,
                                               const SquarenessOptions& options);

/// Fails unless the second error is that of the other axis across the first: EYX and EXY, EZX and EXZ, EZY and EYZ.
Result<void> check_square_pair(const MotionName& first, const MotionName& second);

}  // namespace axiometry::error_motions
