// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/volumetric/field/error_model.h"

/// The same errors with the functional point of every axis at the machine's zero, as controls lever them.
namespace axiometry::volumetric {

bool is_at_machine_zero(const MachineModel& machine);

/// E_a(q) less ω_a(q) × c_a, straightness levelled again, its slopes in the squareness: what identify() finds of the
/// same lengths without functional points. The error of the tool point is the same, but for a motion of the whole
/// machine and a constant of each tool, which nothing tells. What needs a rotation that is not told is not told either.
ErrorModel at_machine_zero(const ErrorModel& model);

}  // namespace axiometry::volumetric
