// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/motions/motion_units.h"

namespace axiometry::formats {

MotionUnit motion_unit_of(const Unit& unit) {
  if (unit.kind == AxisKind::linear) return MotionUnit::um;
  return unit.name.ends_with("rad") ? MotionUnit::urad : MotionUnit::arcsec;
}

double motion_value(const Unit& unit, double value) {
  if (unit.name == "urad") return value;
  if (unit.name == "mrad") return value * 1e3;
  if (unit.name == "rad") return value * 1e6;
  return deviation_in(unit, value).in_native();
}

}  // namespace axiometry::formats
