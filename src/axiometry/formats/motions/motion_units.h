// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/formats/text/units.h"
#include "axiometry/model/motion_series.h"

/// Units of files as those of readings of straightness and rotations.
namespace axiometry::formats {

/// As find_unit(), and the inclinations in which levels show angles: µm/m is urad, mm/m mrad. The tangent counts as the
/// angle, which is 0.0003 µrad at 1 mm/m and 0.3 µrad at 10 mm/m.
const Unit* find_motion_unit(std::string_view spelling);

/// Lengths as µm, ″ and ° as ″, µrad, mrad and rad as µrad.
MotionUnit motion_unit_of(const Unit& unit);

/// A number of that unit in motion_unit_of() it. Radians by powers of ten alone, so that 0.1 µrad stays 0.1.
double motion_value(const Unit& unit, double value);

}  // namespace axiometry::formats
