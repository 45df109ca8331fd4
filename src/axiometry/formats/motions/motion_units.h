// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/formats/text/units.h"
#include "axiometry/model/motion_series.h"

/// Units of files as those of readings of straightness and rotations.
namespace axiometry::formats {

/// Lengths as µm, ″ and ° as ″, µrad, mrad and rad as µrad.
MotionUnit motion_unit_of(const Unit& unit);

/// A number of that unit in motion_unit_of() it. Radians by powers of ten alone, so that 0.1 µrad stays 0.1.
double motion_value(const Unit& unit, double value);

}  // namespace axiometry::formats
