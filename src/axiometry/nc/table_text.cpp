// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/numbers.h"
#include "axiometry/nc/safe_text.h"

namespace axiometry::nc {
namespace {

constexpr int count_decimals = 6;
constexpr double last_digit_of_count = 0.6e-6;  // half of it, and what doubles round
constexpr std::size_t comment_width = 90;

}  // namespace

std::string fixed_number(double x, int decimals) {
  std::string text = fmt::format("{:.{}f}", x, decimals);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string trimmed_fixed(double x, int decimals) {
  std::string text = fixed_number(x, decimals);
  while (text.ends_with('0') && !text.ends_with(".0")) text.pop_back();
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

std::optional<std::vector<double>> numbers_of(std::string_view text, std::string_view separators) {
  std::vector<double> numbers;
  const std::string stops = " \t" + std::string(separators);
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
    return fail(
        fmt::format("found a {} axis, which {} has no such table for", axis_kind_name(correction.kind()), table.title));
  const std::vector<double>& positions = correction.positions();
  if (limits.points > 0 && positions.size() > limits.points)
    return fail(fmt::format("found {} positions, expected at most {}, which is what {} takes", positions.size(),
                            limits.points, table.title));
  if (table.curves == TableCurves::both_ways && table.backlash.empty()) AXIOMETRY_TRY_VOID(check_one_curve(correction));
  if (limits.closes && is_whole_turn(correction))
    for (const Direction direction : {Direction::up, Direction::down})
      if (std::abs(correction.values(direction).front() - correction.values(direction).back()) > 1e-6)
        return fail(fmt::format(
            "found corrections of {} and {} ″ a whole turn apart, expected the same: it is one place",
            format_rounded(correction.values(direction).front()), format_rounded(correction.values(direction).back())));
  if (!limits.equidistant) return {};
  if (positions.size() < 2) return fail("found one position, expected at least two");
  const auto step = common_step(positions);
  if (!step)
    return fail(
        fmt::format("found positions of uneven spacing, expected an even one, which is what {} takes", table.title));
  if (limits.step_native > 0.0 && std::abs(*step - limits.step_native) > 1e-6)
    return fail(fmt::format("found a spacing of {}, expected {}, the only one of {}", format_rounded(*step),
                            format_rounded(limits.step_native), table.title));
  return {};
}

Result<void> check_origin(const AxisCorrection& correction, const AxisTable& table, double reference) {
  constexpr double slack_native = 1e-6, slack_deviation = 1e-6;
  if (table.limits.origin == TableOrigin::anywhere) return {};
  const std::vector<double>& positions = correction.positions();
  const auto step = common_step(positions);
  const double steps = step ? (reference - positions.front()) / *step : 0.0;
  const bool fits = table.limits.origin == TableOrigin::first  ? std::abs(reference - positions.front()) <= slack_native
                    : table.limits.origin == TableOrigin::last ? std::abs(reference - positions.back()) <= slack_native
                                                               : std::abs(steps - std::round(steps)) <= slack_native;
  if (!fits)
    return fail(
        fmt::format("found the reference point at {} and positions from {} to {}, expected it {}, which is what "
                    "{} needs",
                    format_rounded(reference), format_rounded(positions.front()), format_rounded(positions.back()),
                    table.limits.origin == TableOrigin::first  ? "at the first"
                    : table.limits.origin == TableOrigin::last ? "at the last"
                                                               : "a whole number of steps from them",
                    table.title));
  const double there = correction.at(reference, Direction::up);
  if (std::abs(there) > slack_deviation)
    return fail(
        fmt::format("found a correction of {} at the reference point, expected 0, which is all that {} can have "
                    "there",
                    format_rounded(there), table.title));
  return {};
}

Result<void> check_axis_word(const AxisTableOptions& options, std::string_view beside) {
  const std::string allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_" + std::string(beside);
  const std::string_view axis = options.axis;
  if (!axis.empty() && axis.size() <= 32 && axis.find_first_not_of(allowed) == std::string_view::npos) return {};
  return fail(
      fmt::format("found the axis {}, expected its name in the control: letters and digits", text::quoted(axis)));
}

bool is_axis_named(std::string_view found, AxisTableOptions& options) {
  if (!std::exchange(options.axis_told, true)) options.axis = found;
  return text::equal_ignoring_case(found, options.axis);
}

Result<void> check_axis_named(std::string_view found, AxisTableOptions& options, const TableLine& line) {
  if (is_axis_named(found, options)) return {};
  return fail(fmt::format("found the axis {}, expected {} alone", text::quoted(found), text::quoted(options.axis)),
              {line.number, 0});
}

std::string count_text(const AxisTableOptions& options) {
  return fmt::format("{} {}", trimmed_fixed(options.resolution, count_decimals), deviation_unit_key(options.kind));
}

Result<void> check_count_text(std::string_view said, AxisTableOptions& options, const TableLine& line) {
  const std::vector<std::string_view> words = text::words(said);
  const auto count = words.size() == 2 ? parse_number(words[0]) : std::nullopt;
  const bool is_linear = words.size() == 2 && words[1] == deviation_unit_key(AxisKind::linear);
  if (!count || !(*count >= resolution_least && *count <= resolution_most) ||
      (!is_linear && words[1] != deviation_unit_key(AxisKind::rotary)))
    return refused(line, "what one count is: a number and um or arcsec");
  const AxisKind kind = is_linear ? AxisKind::linear : AxisKind::rotary;
  if (kind == options.kind && !std::exchange(options.resolution_told, true)) options.resolution = *count;
  if (kind == options.kind && std::abs(*count - options.resolution) <= last_digit_of_count) return {};
  return fail(fmt::format("found a table in counts of {} {}, expected {} {}", format_rounded(*count, 6),
                          deviation_unit(kind), format_rounded(options.resolution, 6), deviation_unit(options.kind)),
              {line.number, 0});
}

bool is_whole_turn(const AxisCorrection& correction) {
  return correction.kind() == AxisKind::rotary &&
         std::abs(correction.positions().back() - correction.positions().front() - 360.0) <= 1e-6;
}

std::string comment_lines(std::string_view mark, std::string_view text) {
  std::string lines;
  for (const std::string& part : wrapped(text, comment_width)) lines += fmt::format("{} {}\n", mark, part);
  return lines;
}

std::string with_warning(std::string table, std::string_view sign, std::string_view warning) {
  if (warning.empty() || sign.empty()) return table;
  const std::string first = wrapped(sign, comment_width).front();
  const std::size_t at = table.find(first);
  if (at == std::string::npos) return table;
  const std::size_t before = at == 0 ? std::string::npos : table.rfind('\n', at - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::string mark(text::trim(std::string_view(table).substr(begin, at - begin)));
  if (mark.empty() || !table.substr(at + first.size()).starts_with('\n')) return table;
  return table.insert(begin, comment_lines(mark, warning));
}

std::optional<Assignment> assignment_of(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  Assignment found;
  found.value = text::trim(line.substr(equals + 1));
  std::string_view left = text::trim(line.substr(0, equals));
  const std::size_t bracket = left.find_first_of("[(");
  found.name = text::trim(left.substr(0, bracket));
  if (bracket != std::string_view::npos) {
    if (left.back() != (left[bracket] == '[' ? ']' : ')')) return std::nullopt;
    for (const std::string_view index : text::split(left.substr(bracket + 1, left.size() - bracket - 2), ','))
      found.indices.push_back(text::trim(index));
  }
  if (found.name.empty() || found.value.empty()) return std::nullopt;
  return found;
}

std::optional<long long> whole_number(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  const auto count = text.size() > 9 ? std::nullopt : parse_count(text);
  if (!count) return std::nullopt;
  return is_negative ? -static_cast<long long>(*count) : static_cast<long long>(*count);
}

std::unexpected<Error> refused(const TableLine& line, std::string_view expected) {
  return fail(fmt::format("found {}, expected {}", text::quoted(line.text), expected), {line.number, 0});
}

Result<AxisCorrection> even_correction(AxisKind kind, double first, double step, std::vector<double> up,
                                       std::vector<double> down) {
  std::vector<double> positions;
  for (std::size_t k = 0; k < up.size(); ++k)
    positions.push_back(std::round((first + step * static_cast<double>(k)) * 1e9) / 1e9);
  return AxisCorrection::make(kind, std::move(positions), std::move(up), std::move(down));
}

long long counts(double value, double resolution) { return std::llround(value / resolution); }

Result<void> check_one_curve(const AxisCorrection& correction) {
  if (correction.same_both_ways()) return {};
  return fail("found a curve for each direction, expected one for both");
}

}  // namespace axiometry::nc
