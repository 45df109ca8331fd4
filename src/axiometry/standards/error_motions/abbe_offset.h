// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/vector3.h"

/// What the rotations of an axis do at another point than that where its displacement was measured (the Abbe offset).
///
/// The moving part of the axis turns by ε = (E_A, E_B, E_C), small angles about X, Y, Z, positive by the right-hand
/// rule (ISO 230-1), and shifts at the measured point by δ = (E_X, E_Y, E_Z). It is rigid: a point of it that stands
/// off the measured one by r = (dx, dy, dz) shifts by δ + ε × r, to first order in ε,
///
///     E_X′ − E_X = E_B dz − E_C dy
///     E_Y′ − E_Y = E_C dx − E_A dz
///     E_Z′ − E_Z = E_A dy − E_B dx
///
/// so that of an X axis a pitch EBX of 10 µrad shows +1 µm more of EXX at a point 100 mm above the measured line, and a
/// yaw ECX of 10 µrad −1 µm at one 100 mm to +Y. r leads from the measured point to the other, both carried by the
/// moving part, in axes of the machine. These are displacements of the moving part. Where it carries the workpiece, the
/// tool sees the opposite sign, as it does of every error of that axis. 1 µrad over 1 mm is 0.001 µm.
/// What the first order leaves out is below |ε|² |r|: 0.01 µm for 100 µrad over 1 m.
namespace axiometry::error_motions {

struct AxisAngles {
  std::array<std::optional<std::vector<double>>, 3> urad;  ///< E_A, E_B, E_C at each position, where they were measured
};

/// E_X, E_Y, E_Z at the other point less those at the measured one, µm, at each position; absent where a rotation that
/// counts was not measured: one that r has no lever for counts nothing. Contract: lists of one length.
std::array<std::optional<std::vector<double>>, 3> abbe_displacement(const AxisAngles& angles, const Vector3& offset_mm);

/// The rotations that E_X, E_Y or E_Z (0, 1, 2) needs for this offset and does not have: "B", "C"; empty for none.
std::string missing_angles(const AxisAngles& angles, const Vector3& offset_mm, std::size_t coordinate);

}  // namespace axiometry::error_motions
