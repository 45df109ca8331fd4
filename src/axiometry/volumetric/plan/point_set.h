// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/base/vector3.h"
#include "axiometry/model/tracking.h"

/// Places at which a calibration looks.
namespace axiometry::volumetric {

/// `count` places of the axes, evenly over a box: shift + k·α modulo 1 of each travel, with α = (g⁻¹, g⁻², g⁻³) and g
/// the root of g⁴ = g + 1, a sequence of low discrepancy that fills evenly however many are taken. `shift` from 0 to 1
/// tells one set from another. Rounded to 0.001 mm, as programs are.
std::vector<Vector3> spread_points(const TravelBox& travel, std::size_t count, Vector3 shift);

/// The same places in an order of little way, from the first on: always to the nearest that is left, then turned around
/// piece by piece for as long as that shortens the way (2-opt, at most 60 rounds). For some thousand places.
std::vector<Vector3> short_tour(std::vector<Vector3> places_mm);

}  // namespace axiometry::volumetric
