// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/standards/error_motions/axis_motion.h"

/// The squareness of two axes from the straightness of each, measured against one optical square.
///
///     θ = atan b of each line,  S = θ_2 − θ_1 + error of the optical square
///
/// always in this order: the other order of the files gives θ_1 − θ_2. The slopes are those of the mean of both
/// directions, or of the one that both lines have; of lines that have none in common, of
/// the one that each has, and S holds what the directions differ by; both by the same reference. This is the maker's
/// rule, for readings whose sense the optical square turns with the beam: positive along n × a_1 and n × a_2, where the
/// axes a_1 and a_2 point along the beam and n is the normal of their plane. Then θ_1 and θ_2 are rotations about n,
/// and S is by how much the second axis is turned about n beyond the first.
///
/// In axes of the machine, where both readings are positive along the positive direction of the other axis, one of the
/// two is opposed to that. With n = a_1 × a_2 it is n × a_1 = a_2 but n × a_2 = −a_1, so that the second axis is turned
/// by −θ_2, and of every plane and in either order
///
///     S = −θ_1 − θ_2 + error of the optical square
///
/// by how much the angle between the positive directions of both axes is larger than 90°. The error of the square is
/// that of the angle which it has in place of those 90°. The location errors of ISO 230-1 are rotations by the
/// right-hand rule of the later axis (X, Y, Z) against the earlier one. X × Y = Z and Y × Z = X, so about Z and X the
/// second axis turns away from the first; Z × X = Y, so about Y the axis Z turns towards X:
///
///     C0Y = S of X and Y,   B0Z = −S of X and Z,   A0Z = S of Y and Z
///
/// Uncertainty: of each slope as axis_motion.h has it; the scatter of the two lines is independent. What the instrument
/// adds to both may be common, with either sign, and counts as the sum of both (at most that, whatever the
/// correlation). The square adds its own. Where nothing tells U of one of the lines there is none of S either.
namespace axiometry::error_motions {

struct SquarenessOptions {
  std::optional<double> square_error_arcsec{};        ///< error of the optical square; nothing stated counts as 0
  std::optional<double> square_uncertainty_arcsec{};  ///< expanded, k = 2, of that error
  bool in_axes = false;  ///< both readings are positive along the positive directions of the axes: S = −θ_1 − θ_2 + …
};

struct MeasuredSquareness {
  PathKind kind_1 = PathKind::mean,
           kind_2 = PathKind::mean;  ///< courses of the lines: of both the same where they can be
  MotionEstimate theta_1_arcsec, theta_2_arcsec;
  MotionEstimate squareness_arcsec;  ///< S
};

/// θ = atan b, in ″, of a slope in µm/m, with its uncertainty.
MotionEstimate slope_angle(const MotionEstimate& slope_um_per_m);

/// Fails where the readings are no straightness, or the two lines have different references or none.
Result<MeasuredSquareness> measured_squareness(const AxisMotion& first, const AxisMotion& second,
                                               const SquarenessOptions& options);

/// Squareness as ISO 230-1 names it.
struct LocationError {
  std::string_view name;  ///< "C0Y", "B0Z" or "A0Z"
  double sign = 1.0;      ///< sign of S in it
  MotionEstimate urad;
};

/// Of two lines in axes of the machine, of which `first` is one; contract: a straightness.
LocationError location_error(const MotionName& first, const MeasuredSquareness& squareness);

/// Fails unless the second error is that of the other axis across the first: EYX and EXY, EZX and EXZ, EZY and EYZ.
Result<void> check_square_pair(const MotionName& first, const MotionName& second);

}  // namespace axiometry::error_motions
