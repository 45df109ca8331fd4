// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/amount_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::app {
namespace {

struct Amount {
  std::optional<double> number;
  std::string_view unit;
};

Amount amount_from(std::string_view text) {
  text = text::trim(text);
  std::size_t end = std::min(text.find_first_not_of("0123456789.+-"), text.size());
  // An exponent is an e with digits behind it; "e" may also begin a unit.
  if (end + 1 < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const std::size_t sign = text[end + 1] == '-' || text[end + 1] == '+';
    const std::size_t digits = std::min(text.find_first_not_of("0123456789", end + 1 + sign), text.size());
    if (digits > end + 1 + sign) end = digits;
  }
  return {parse_number(text.substr(0, end)), text::trim(text.substr(end))};
}

/// A unit and what one of it is: factor / divisor of the quantity's own.
struct AmountUnit {
  std::string_view name;
  double factor;
  double divisor = 1.0;
};

/// The number in the first unit of the list.
Result<double> parse(std::string_view text, std::string_view what, std::span<const AmountUnit> units) {
  const auto [number, unit] = amount_from(text);
  if (number)
    for (const AmountUnit& u : units)
      if (u.name == unit) return *number * u.factor / u.divisor;
  std::vector<std::string_view> names;
  for (const AmountUnit& u : units)
    if (!u.name.empty()) names.push_back(u.name);
  return fail(fmt::format("found {}, expected {} in {}", text::quoted(text), what, fmt::join(names, ", ")));
}

/// In µm or ″.
Result<double> parse_native(std::string_view text, std::string_view what, AxisKind kind) {
  const auto [number, name] = amount_from(text);
  const formats::Unit* unit = formats::find_unit(name);
  if (number && unit != nullptr && unit->kind == kind) return formats::deviation_in(*unit, *number).in_native();
  std::vector<std::string_view> names;
  for (const formats::Unit& u : formats::units())
    if (u.kind == kind) names.push_back(u.name);
  return fail(fmt::format("found {}, expected {} in {}", text::quoted(text), what, fmt::join(names, ", ")));
}

/// The number as a quantity.
template <typename Quantity>
Result<Quantity> as(Result<double> number, Quantity (*make)(double)) {
  AXIOMETRY_TRY(const double x, std::move(number));
  return make(x);
}

}  // namespace

Result<Deviation> parse_deviation(std::string_view text, AxisKind kind) {
  return as(parse_native(text, kind == AxisKind::linear ? "a length" : "an angle", kind), Deviation::native);
}

Result<Position> parse_position(std::string_view text, AxisKind kind) {
  AXIOMETRY_TRY(const double native, parse_native(text, "a position", kind));
  return Position::native(native / deviation_per_position(kind));
}

Result<Duration> parse_duration(std::string_view text) {
  constexpr AmountUnit units[] = {{"s", 1.0}, {"ms", 1.0, 1e3}, {"us", 1.0, 1e6}, {"min", 60.0}, {"h", 3600.0}};
  return as(parse(text, "a time", units), Duration::s);
}

Result<Duration> parse_period(std::string_view text) {
  constexpr AmountUnit units[] = {{"Hz", 1.0}, {"kHz", 1e3}, {"mHz", 1.0, 1e3}};
  AXIOMETRY_TRY(const double hertz, parse(text, "a frequency", units));
  if (!(hertz > 0.0)) return fail(fmt::format("found {}, expected a frequency above 0", text::quoted(text)));
  return Duration::s(1.0 / hertz);
}

Result<RelativeLength> parse_slope(std::string_view text, AxisKind kind) {
  constexpr AmountUnit linear[] = {{"um/m", 1.0}, {"ppm", 1.0}, {"µm/m", 1.0}};
  constexpr AmountUnit rotary[] = {{"arcsec/deg", 1e6, 3600.0}, {"ppm", 1.0}};
  const auto units =
      kind == AxisKind::linear ? std::span<const AmountUnit>(linear) : std::span<const AmountUnit>(rotary);
  return as(parse(text, "a slope", units), RelativeLength::um_per_m);
}

Result<double> parse_probability(std::string_view text) {
  constexpr AmountUnit units[] = {{"", 1.0}, {"%", 1.0, 100.0}};
  const auto number = parse(text, "a probability", units);
  if (number && *number >= 0.0 && *number <= 1.0) return *number;
  return fail(fmt::format("found {}, expected a probability from 0 to 1, or in %", text::quoted(text)));
}

Result<Angle> parse_phase(std::string_view text) {
  constexpr AmountUnit units[] = {{"deg", 1.0}, {"°", 1.0}};
  return as(parse(text, "an angle", units), Angle::deg);
}

Result<Temperature> parse_temperature(std::string_view text) {
  constexpr AmountUnit units[] = {{"C", 1.0}, {"°C", 1.0}, {"degC", 1.0}};
  return as(parse(text, "a temperature", units), Temperature::celsius);
}

Result<ExpansionCoefficient> parse_expansion(std::string_view text) {
  constexpr AmountUnit units[] = {{"um/m/K", 1.0}, {"ppm/K", 1.0}, {"um/m/C", 1.0}, {"", 1.0}};
  return as(parse(text, "an expansion coefficient", units), ExpansionCoefficient::um_per_m_K);
}

Result<double> parse_bare(std::string_view text) {
  const auto number = parse_number(text::trim(text));
  if (!number) return fail(fmt::format("found {}, expected a number", text::quoted(text)));
  return *number;
}

}  // namespace axiometry::app
