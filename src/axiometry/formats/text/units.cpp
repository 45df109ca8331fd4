// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/base/decimal_tie.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::formats {
namespace {

constexpr double arcsec_per_rad = 648000.0 / std::numbers::pi;

constexpr Unit table[] = {
    {"um", "µm", AxisKind::linear, 1, 1},
    {"mm", "mm", AxisKind::linear, 1000, 1},
    {"nm", "nm", AxisKind::linear, 1, 1000},
    {"m", "m", AxisKind::linear, 1e6, 1},
    {"in", "in", AxisKind::linear, 25400, 1},
    {"uin", "µin", AxisKind::linear, 254, 10000},
    {"arcsec", "″", AxisKind::rotary, 1, 1},
    {"deg", "°", AxisKind::rotary, 3600, 1},
    {"mdeg", "m°", AxisKind::rotary, 36, 10},
    {"rad", "rad", AxisKind::rotary, arcsec_per_rad, 1},
    {"mrad", "mrad", AxisKind::rotary, arcsec_per_rad, 1e3},
    {"urad", "µrad", AxisKind::rotary, arcsec_per_rad, 1e6},
};

struct Spelling {
  std::string_view text;
  std::string_view name;
};

// The three with Â went through a wrong code page: UTF-8 that was read as Latin-1 and written again.
constexpr Spelling spellings[] = {
    {"\u00C2\u00B5m", "um"}, {"\u00C2\u00B0", "deg"},  {"\u00C2\u00B5rad", "urad"},
    {"\u03BCm", "um"},       {"micron", "um"},         {"microns", "um"},
    {"micrometre", "um"},    {"micrometres", "um"},    {"micrometer", "um"},
    {"micrometers", "um"},   {"millimetre", "mm"},     {"millimetres", "mm"},
    {"millimeter", "mm"},    {"millimeters", "mm"},    {"inch", "in"},
    {"inches", "in"},        {"\u03BCin", "uin"},      {"\"", "arcsec"},
    {"arcsecond", "arcsec"}, {"arcseconds", "arcsec"}, {"arc-sec", "arcsec"},
    {"arc sec", "arcsec"},   {"degree", "deg"},        {"degrees", "deg"},
    {"\u03BCrad", "urad"},
};

/// What a unit makes of a number of a file: read with half an ulp, then multiplied and divided. Decimals stay decimals.
double converted(double x) { return nearest_decimal(x, 4.0 * unit_roundoff * std::abs(x)); }

}  // namespace

std::span<const Unit> units() { return table; }

const Unit* find_unit(std::string_view spelling) {
  for (const Spelling& s : spellings)
    if (text::equal_ignoring_case(s.text, spelling)) spelling = s.name;
  for (const Unit& unit : table)
    if (text::equal_ignoring_case(unit.name, spelling) || text::equal_ignoring_case(unit.symbol, spelling))
      return &unit;
  return nullptr;
}

std::string unit_names() {
  std::string names;
  for (const Unit& unit : table) names += fmt::format("{}{}", names.empty() ? "" : ", ", unit.name);
  return names;
}

Position position_in(const Unit& unit, double x) {
  // Millimetres and degrees must stay what was written: the quotient is exactly 1 for them.
  const double per_position = deviation_per_position(unit.kind);
  if (unit.factor == per_position && unit.divisor == 1.0) return Position::native(x);
  if (unit.factor >= per_position) return Position::native(converted(x * (unit.factor / per_position) / unit.divisor));
  return Position::native(converted(x * unit.factor / (unit.divisor * per_position)));
}

Deviation deviation_in(const Unit& unit, double x) {
  if (unit.factor == unit.divisor) return Deviation::native(x);
  return Deviation::native(converted(x * unit.factor / unit.divisor));
}

Result<double> native_deviation(const ReadingRule& rule, Position target, double value) {
  double deviation = 0.0;
  if (rule.measured == Measured::deviation) {
    deviation = deviation_in(*rule.unit, value).in_native();
  } else {
    const double position = position_in(*rule.unit, value).in_native();
    const double difference = position - target.in_native();
    if (rule.unit->kind == AxisKind::rotary && std::abs(difference) > 180.0)
      return fail(fmt::format("found a measured position {}° from its target, expected both within half a turn",
                              format_exact(difference)));
    // Each of the two is half an ulp off its decimal, their difference and its product another; twice that.
    const double per_position = deviation_per_position(rule.unit->kind);
    const double magnitude = (std::abs(position) + std::abs(target.in_native()) + std::abs(difference)) * per_position;
    deviation = nearest_decimal(difference * per_position, 2.0 * unit_roundoff * magnitude);
  }
  if (std::abs(deviation) <= largest_stated) return deviation;
  return fail(fmt::format("found a deviation of {} {}, expected a magnitude up to 1e9", format_exact(deviation),
                          deviation_unit(rule.unit->kind)));
}

Result<AxisKind> kind_of(const Unit& target_unit, const Unit& reading_unit) {
  if (target_unit.kind == reading_unit.kind) return target_unit.kind;
  return fail(fmt::format("found targets in {} and readings in {}, expected both as lengths or both as angles",
                          target_unit.name, reading_unit.name));
}

}  // namespace axiometry::formats
