// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/machine/kinematics.h"

#include <cmath>

namespace axiometry::volumetric {
namespace {

Vector3 translation(const ErrorValues& errors, std::size_t a) {
  const auto& e = errors.motions[a];
  return {e[0], e[1], e[2]};
}
Vector3 rotation(const ErrorValues& errors, std::size_t a) {
  const auto& e = errors.motions[a];
  return {e[3], e[4], e[5]};
}

/// Turned by angles about X, then Y, then Z, rad.
Vector3 turned(Vector3 p, Vector3 angles) {
  const double ca = std::cos(angles.x), sa = std::sin(angles.x);
  p = {p.x, ca * p.y - sa * p.z, sa * p.y + ca * p.z};
  const double cb = std::cos(angles.y), sb = std::sin(angles.y);
  p = {cb * p.x + sb * p.z, p.y, -sb * p.x + cb * p.z};
  const double cc = std::cos(angles.z), sc = std::sin(angles.z);
  return {cc * p.x - sc * p.y, sc * p.x + cc * p.y, p.z};
}

/// d_a, from the workpiece's frame as it would be without error motions.
Vector3 direction(const ErrorValues& errors, std::size_t a) {
  constexpr double rad = 1e-6;
  const double c = rad * errors.squareness_urad[0], b = rad * errors.squareness_urad[1],
               t = rad * errors.squareness_urad[2];
  if (a == 0) return {1.0, 0.0, 0.0};
  if (a == 1) return {-std::sin(c), std::cos(c), 0.0};
  return turned({0.0, 0.0, 1.0}, {t, b, 0.0});
}

}  // namespace

Vector3 displacement_um(const MachineModel& machine, const ErrorValues& errors, Vector3 axes_mm, Vector3 tool_mm) {
  constexpr double m_per_mm = 1e-3;
  const std::array<Vector3, 3> levers = machine.levers_mm(axes_mm, tool_mm);
  const auto [c0y, b0z, a0z] = errors.squareness_urad;
  Vector3 sum = m_per_mm * Vector3{-c0y * axes_mm.y + b0z * axes_mm.z, -a0z * axes_mm.z, 0.0};
  for (std::size_t a = 0; a < axis_count; ++a)
    sum += translation(errors, a) + cross(rotation(errors, a), m_per_mm * levers[a]);
  return sum;
}

Vector3 displacement_exact_um(const MachineModel& machine, const ErrorValues& errors, Vector3 axes_mm,
                              Vector3 tool_mm) {
  constexpr double mm_per_um = 1e-3, rad_per_urad = 1e-6;
  Vector3 p = tool_mm;
  for (std::size_t k = 3; k-- > 0;) {
    const std::size_t a = machine.chain.order()[k];
    const Vector3 move = axes_mm[a] * direction(errors, a);
    const Vector3 at = machine.functional_point_mm[a];
    const auto err = [&](Vector3 v) {
      return at + turned(v - at, rad_per_urad * rotation(errors, a)) + mm_per_um * translation(errors, a);
    };
    p = machine.chain.carries_workpiece(a) ? err(move + p) : move + err(p);
  }
  return 1000.0 * (p - (axes_mm + tool_mm));
}

}  // namespace axiometry::volumetric
