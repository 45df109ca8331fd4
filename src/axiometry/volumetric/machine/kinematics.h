// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "axiometry/base/vector3.h"
#include "axiometry/volumetric/machine/error_motion.h"
#include "axiometry/volumetric/machine/machine_model.h"

/// From the errors of the axes to the error of the tool point. Derivation: docs/theory/volumetric.md.
namespace axiometry::volumetric {

/// All errors when the axes stand somewhere: [axis][motion] in µm and µrad; squareness C0Y, B0Z, A0Z in µrad.
struct ErrorValues {
  std::array<std::array<double, motion_count>, axis_count> motions{};
  std::array<double, 3> squareness_urad{};
};

/// δ of the tool point relative to the workpiece to first order, µm:
///   δ = Σ_a [E_a + ω_a × r_a] + (−C0Y·y + B0Z·z, −A0Z·z, 0).
/// Within 2e-3 µm of displacement_exact_um() for errors of 50 µm and 50 µrad in 1 m.
Vector3 displacement_um(const MachineModel& machine, const ErrorValues& errors, Vector3 axes_mm, Vector3 tool_mm);

/// The same by homogeneous transformations, in order from the workpiece to the tool,
///   p = H_1 H_2 H_3 t;  H_a = T(q_a d_a)·Err_a of an axis that carries the tool, Err_a·T(q_a d_a) of one that carries
/// the workpiece, where d_a is the axis' direction turned by its squareness and
/// Err_a = T(E_a)·Rz(E_Ca)·Ry(E_Ba)·Rx(E_Aa) acts at the functional point.
Vector3 displacement_exact_um(const MachineModel& machine, const ErrorValues& errors, Vector3 axes_mm, Vector3 tool_mm);

}  // namespace axiometry::volumetric
