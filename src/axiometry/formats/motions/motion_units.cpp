// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/motions/motion_units.h"

#include <utility>

#include "axiometry/base/text/text.h"

namespace axiometry::formats {

const Unit* find_motion_unit(std::string_view spelling) {
  constexpr std::pair<std::string_view, std::string_view> inclinations[] = {
      {"um/m", "urad"}, {"\u00B5m/m", "urad"}, {"\u03BCm/m", "urad"}, {"\u00C2\u00B5m/m", "urad"}, {"mm/m", "mrad"}};
  for (const auto& [inclination, angle] : inclinations)
    if (text::equal_ignoring_case(inclination, spelling)) return find_unit(angle);
  return find_unit(spelling);
}

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
