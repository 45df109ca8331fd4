// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/number_text.h"
#include "axiometry/nc/numbers.h"

namespace axiometry::nc {

std::string fixed_number(double x, int decimals) {
  std::string text = fmt::format("{:.{}f}", x, decimals);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

double position_per_unit(const AxisTableOptions& options) {
  return options.kind == AxisKind::linear && options.in_inch ? mm_per_inch : 1.0;
}

double unit_per_deviation(const AxisTableOptions& options) {
  return 1.0 / deviation_per_position(options.kind) / position_per_unit(options);
}

int table_decimals(const AxisTableOptions& options) {
  return options.kind == AxisKind::linear && options.in_inch ? 8 : 6;
}

std::vector<TableLine> lines_of(std::string_view text) {
  std::vector<TableLine> lines;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back({++number, line});
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return lines;
}

std::optional<std::vector<double>> numbers_of(std::string_view text, std::string_view parting) {
  std::vector<double> numbers;
  const std::string stops = " \t" + std::string(parting);
  while (true) {
    const std::size_t begin = text.find_first_not_of(stops);
    if (begin == std::string_view::npos) return numbers;
    text = text.substr(begin);
    const std::size_t end = std::min(text.find_first_of(stops), text.size());
    const auto number = parse_number(text.substr(0, end));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    text = text.substr(end);
  }
}

std::optional<double> common_step(const std::vector<double>& positions) {
  if (positions.size() < 2) return std::nullopt;
  const double step = (positions.back() - positions.front()) / static_cast<double>(positions.size() - 1);
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (std::abs(positions[k] - positions.front() - step * static_cast<double>(k)) > 1e-6) return std::nullopt;
  return step;
}

Result<void> check_limits(const AxisCorrection& correction, const AxisTable& table) {
  const AxisTableLimits& limits = table.limits;
  const bool is_linear = correction.kind() == AxisKind::linear;
  if (is_linear ? !limits.linear : !limits.rotary)
    return fail(fmt::format("found a {} axis, which {} has no such table for", axis_kind_name(correction.kind()),
                            table.title));
  const std::vector<double>& positions = correction.positions();
  if (limits.points > 0 && positions.size() > limits.points)
    return fail(fmt::format("found {} positions, expected at most {}, which is what {} takes", positions.size(),
                            limits.points, table.title));
  if (table.curves != TableCurves::each_way && table.curves != TableCurves::with_backlash)
    AXIOMETRY_TRY_VOID(check_one_curve(correction));
  if (!limits.equidistant) return {};
  const auto step = common_step(positions);
  if (!step)
    return fail(fmt::format("found positions of uneven spacing, expected an even one, which is what {} takes",
                            table.title));
  if (limits.step_native > 0.0 && std::abs(*step - limits.step_native) > 1e-6)
    return fail(fmt::format("found a spacing of {}, expected {}, the only one of {}", format_exact(*step),
                            format_exact(limits.step_native), table.title));
  if (limits.origin == TableOrigin::anywhere) return {};
  const bool is_first = limits.origin == TableOrigin::first;
  if (correction.at(is_first ? positions.front() : positions.back(), Direction::up) != 0.0)
    return fail(fmt::format("found a correction at the {} position, expected 0: that is the reference point of {}",
                            is_first ? "first" : "last", table.title));
  return {};
}

long long counts(double value, double resolution) { return std::llround(value / resolution); }

Result<void> check_one_curve(const AxisCorrection& correction) {
  if (correction.same_both_ways()) return {};
  return fail("found a curve for each direction, expected one for both");
}

}  // namespace axiometry::nc
