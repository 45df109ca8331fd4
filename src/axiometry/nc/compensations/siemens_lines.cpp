// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/compensations/siemens_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::nc::siemens {

Grid grid_of_table(const AxisCorrection& correction, const AxisTableOptions& options) {
  const auto step = common_step(correction.positions());
  AXIOMETRY_CONTRACT(step);  // check_limits()
  const double unit = position_per_unit(options);
  // MAX is MIN and so many steps as the steps are printed, so that the control counts as many points.
  const int decimals = table_decimals(options) + 2;
  const auto printed = [&](double x) { return parse_number(fixed_number(x / unit, decimals)).value_or(0.0); };
  const double first = printed(correction.positions().front()), spacing = printed(*step);
  const double last = first + spacing * static_cast<double>(correction.positions().size() - 1);
  return Grid{trimmed_fixed(spacing, decimals), trimmed_fixed(first, decimals), trimmed_fixed(last, decimals)};
}

Result<std::vector<TableLine>> assignments(std::string_view text) {
  std::vector<TableLine> found;
  std::size_t end = 0;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text.substr(0, line.text.find(';')));
    if (line.text.empty()) continue;
    if (end > 0) return refused(line, fmt::format("nothing behind the end in line {}", end));
    if (text::equal_ignoring_case(line.text, "M17") || text::equal_ignoring_case(line.text, "M02") ||
        text::equal_ignoring_case(line.text, "M30"))
      end = line.number;
    else if (!line.text.starts_with('%') && !text::to_lower(line.text.substr(0, 9)).starts_with("chandata("))
      found.push_back(line);
  }
  if (end == 0) return fail("found no M17 at the end, expected one: the file may be cut");
  return found;
}

Result<void> Values::put(std::string_view index, double value, const TableLine& line) {
  const auto n = whole_number(index);
  if (!n || *n < 0 || *n >= static_cast<long long>(AxisCorrection::nodes_max))
    return refused(line, "a point from 0 upward");
  if (!values_.emplace(*n, value).second) return refused(line, "each point once");
  return {};
}

Result<std::vector<double>> Values::all(std::size_t count) const {
  std::vector<double> values;
  for (const auto& [n, value] : values_) {
    if (n != static_cast<long long>(values.size()))
      return fail(fmt::format("found no point {}, expected all without a gap", values.size()));
    values.push_back(value);
  }
  if (values.size() != count)
    return fail(fmt::format("found {} points, expected {} by MIN, MAX and STEP", values.size(), count));
  return values;
}

bool Frame::put(std::string_view name, double value) {
  std::optional<double>* place = name == "step"        ? &step
                                 : name == "min"       ? &min
                                 : name == "max"       ? &max
                                 : name == "is_modulo" ? &is_modulo
                                                       : nullptr;
  if (!place || *place) return false;
  *place = value;
  return true;
}

Result<std::size_t> Frame::points(const AxisTableOptions& options) const {
  if (!step || !min || !max || !is_modulo)
    return fail(fmt::format("found no {}, expected STEP, MIN, MAX and IS_MODULO", !step  ? "STEP"
                                                                                  : !min ? "MIN"
                                                                                  : !max ? "MAX"
                                                                                         : "IS_MODULO"));
  const double steps = (*max - *min) / *step;
  if (!(*step > 0.0) || !(steps >= 1.0) || std::abs(steps - std::round(steps)) > 1e-3 ||
      steps >= static_cast<double>(AxisCorrection::nodes_max))
    return fail(fmt::format("found steps of {} from {} to {}, expected a whole number of them", format_rounded(*step),
                            format_rounded(*min), format_rounded(*max)));
  if (*is_modulo != 0.0 && (options.kind == AxisKind::linear || std::abs(*max - *min - 360.0) > 1e-6))
    return fail("found IS_MODULO, expected it on a rotary axis whose table is a whole turn");
  return static_cast<std::size_t>(std::llround(steps)) + 1;
}

}  // namespace axiometry::nc::siemens
