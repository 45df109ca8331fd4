// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tolerance_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/units.h"

namespace axiometry::app {

Result<ToleranceText> parse_tolerance(std::string_view text) {
  const auto expected = [&](std::string_view what) {
    return fail(fmt::format("found the tolerance {}, expected {}", text::quoted(text), what));
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return expected("PARAMETER=LIMIT such as A=10um");
  const auto* parameter = iso230_2::find_parameter(text::trim(text.substr(0, equals)));
  if (parameter == nullptr) {
    std::vector<std::string_view> keys;
    for (const auto& p : iso230_2::parameters) keys.push_back(p.key);
    return expected(fmt::format("one of the parameters {}", fmt::join(keys, ", ")));
  }
  const std::string_view limit = text::trim(text.substr(equals + 1));
  const std::size_t digits_end = std::min(limit.find_first_not_of("0123456789.+-eE"), limit.size());
  const std::string_view unit = text::trim(limit.substr(digits_end));
  const auto value = parse_number(text::trim(limit.substr(0, digits_end)));
  if (!value || *value < 0) return expected("a limit that is a number, 0 or more, with a decimal point");
  if (formats::find_unit(unit) == nullptr) return expected("a limit with its unit um, mm, nm, arcsec or deg");
  return ToleranceText{parameter, *value, std::string(unit)};
}

Result<std::vector<iso230_2::Tolerance>> tolerances_for(AxisKind kind, const std::vector<ToleranceText>& texts) {
  std::vector<iso230_2::Tolerance> tolerances;
  for (const ToleranceText& t : texts) {
    const formats::Unit& unit = *formats::find_unit(t.unit);
    if (unit.kind != kind)
      return fail(fmt::format("found the tolerance {}={}{} for a {} axis, expected a limit in {}", t.parameter->key,
                              format_exact(t.value), t.unit, axis_kind_name(kind),
                              kind == AxisKind::linear ? "um, mm or nm" : "arcsec or deg"));
    tolerances.push_back({t.parameter, formats::deviation_in(unit, t.value)});
  }
  return tolerances;
}

}  // namespace axiometry::app
