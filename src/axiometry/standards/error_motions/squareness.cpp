// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/error_motions/squareness.h"

#include <fmt/format.h>

#include <array>

#include "axiometry/base/contract.h"

namespace axiometry::error_motions {

// ∂θ/∂b = 1/(1 + b²), with b in 1e-6.
MotionEstimate slope_angle(const MotionEstimate& slope_um_per_m) {
  const double b = 1e-6 * slope_um_per_m.value;
  const double factor = slope_arcsec(1.0) / (1.0 + b * b);
  MotionEstimate angle = slope_um_per_m;
  angle.value = slope_arcsec(slope_um_per_m.value);
  angle.scatter_u *= factor;
  if (angle.instrument_u) *angle.instrument_u *= factor;
  return combined(angle);
}

Result<MeasuredSquareness> measured_squareness(const AxisMotion& first, const AxisMotion& second,
                                               const SquarenessOptions& options) {
  if (is_angle(first.unit) || is_angle(second.unit))
    return fail("found readings of an angle, expected the straightness of both axes");
  if (first.reference == Reference::none || first.reference != second.reference)
    return fail("found two references, expected the same line for both axes");
  MeasuredSquareness s;
  const MotionPath *path_1 = &first.principal(), *path_2 = &second.principal();
  for (const MotionPath& path : first.paths)
    for (const MotionPath& other : second.paths)
      if (path.kind == other.kind) path_1 = &path, path_2 = &other;  // the mean of both directions is the last
  s.kind_1 = path_1->kind;
  s.kind_2 = path_2->kind;
  s.theta_1_arcsec = slope_angle(path_1->slope_per_m);
  s.theta_2_arcsec = slope_angle(path_2->slope_per_m);
  const MotionEstimate &one = s.theta_1_arcsec, &two = s.theta_2_arcsec;
  MotionEstimate sum;
  sum.value = (options.in_axes ? -two.value : two.value) - one.value + options.square_error_arcsec.value_or(0.0);
  using Scatter = MotionEstimate::Scatter;
  const bool single = one.scatter == Scatter::residuals || two.scatter == Scatter::residuals;
  sum.scatter = single ? Scatter::residuals : Scatter::runs;
  const std::array parts = {ScatterPart{one.scatter_u, one.scatter_degrees},
                            ScatterPart{two.scatter_u, two.scatter_degrees}};
  const ScatterPart scatter = combined_scatter(parts);
  sum.scatter_u = scatter.u;
  sum.scatter_degrees = scatter.degrees;
  if (one.instrument_u || two.instrument_u)
    sum.instrument_u = one.instrument_u.value_or(0.0) + two.instrument_u.value_or(0.0);
  if (options.square_uncertainty_arcsec) sum.other_u = *options.square_uncertainty_arcsec / 2.0;
  s.squareness_arcsec = combined(sum);
  if (!one.tells_U() || !two.tells_U()) s.squareness_arcsec.u.reset();
  return s;
}

LocationError location_error(const MotionName& first, const MeasuredSquareness& squareness) {
  AXIOMETRY_CONTRACT(first.straightness());
  const auto in_plane = [&](char letter) { return first.coordinate == letter || first.axis == letter; };
  LocationError error{!in_plane('Z') ? "C0Y" : in_plane('X') ? "B0Z" : "A0Z", 1.0, squareness.squareness_arcsec};
  if (error.name == "B0Z") error.sign = -1.0;
  const double urad = 1.0 / slope_arcsec(1.0);
  error.urad.value *= error.sign * urad;
  error.urad.scatter_u *= urad;
  if (error.urad.instrument_u) *error.urad.instrument_u *= urad;
  if (error.urad.other_u) *error.urad.other_u *= urad;
  const bool tells_U = error.urad.tells_U();
  error.urad = combined(error.urad);
  if (!tells_U) error.urad.u.reset();
  return error;
}

Result<void> check_square_pair(const MotionName& first, const MotionName& second) {
  if (first.straightness() && second == MotionName{first.axis, first.coordinate}) return {};
  return fail(fmt::format("found the errors {} and {}, expected two straightnesses in one plane, such as EYX and EXY",
                          first.text(), second.text()));
}

}  // namespace axiometry::error_motions
