// SPDX-License-Identifier: Apache-2.0
//
// Squareness of Marlin: M852 sets how far X leans over Y (I), X over Z (J) and Y over Z (K), as factors. The firmware
// takes factor times the second position off the first: x − y I. One straight line through 0, whatever the direction.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/unit_sizes.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable marlin_skew_axis_table;

namespace marlin_skew {
namespace {

constexpr std::string_view range_mark = "; range ";
constexpr double factor_most = 1.0;
constexpr int factor_decimals = 8;  // 0.01 µm over a metre

struct Factor {
  std::string_view along, moved;
  char letter;
};
constexpr std::array factors = {Factor{"Y", "X", 'I'}, Factor{"Z", "X", 'J'}, Factor{"Z", "Y", 'K'}};

Result<char> letter_of(const AxisTableOptions& options) {
  for (const Factor& factor : factors)
    if (text::equal_ignoring_case(options.axis, factor.along) &&
        text::equal_ignoring_case(options.output_axis, factor.moved))
      return factor.letter;
  return fail(fmt::format(
      "found {} to be moved by the position of {}, expected X by Y, X by Z or Y by Z, which M852 has",
      text::quoted(options.output_axis.empty() ? options.axis : options.output_axis), text::quoted(options.axis)));
}

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, marlin_skew_axis_table));
  AXIOMETRY_TRY(const char letter, letter_of(options));
  if (options.reference != 0.0)
    return fail(fmt::format("found the reference point at {}, expected 0, from where M852 counts",
                            fixed_number(options.reference, 3)));
  const std::vector<double>& positions = correction.positions();
  if (positions.size() < 2) return fail("found one position, expected at least two");
  const std::vector<double>& values = correction.values(Direction::up);
  const double slope = (values.back() - values.front()) / (positions.back() - positions.front()) / um_per_mm;
  if (std::abs(slope) > factor_most) return fail(fmt::format("found a factor of {:.3f}, expected -1 to 1", -slope));
  return comment_lines(";", marlin_skew_axis_table.sign) +
         fmt::format("{}{} to {}\nM852 {}{}\nM500\n", range_mark, trimmed_fixed(positions.front(), 6),
                     trimmed_fixed(positions.back(), 6), letter, fixed_number(-slope, factor_decimals));
}

struct Found {
  std::optional<std::pair<double, double>> range;
  std::optional<double> factor;
  bool is_kept = false;
};

Result<void> take(TableLine line, char letter, Found& found) {
  if (line.text.starts_with(range_mark)) {
    const auto words = text::words(line.text.substr(range_mark.size()));
    const auto low = words.size() == 3 ? parse_number(words[0]) : std::nullopt;
    const auto high = words.size() == 3 ? parse_number(words[2]) : std::nullopt;
    if (found.range || !low || !high || !(*low < *high)) return refused(line, "; range LOW to HIGH, once");
    found.range = {*low, *high};
    return {};
  }
  line.text = text::trim(line.text.substr(0, line.text.find(';')));
  if (line.text.empty()) return {};
  if (line.text == "M500" && found.factor && !found.is_kept) {
    found.is_kept = true;
    return {};
  }
  const auto words = text::words(line.text);
  const auto factor = words.size() == 2 && words[0] == "M852" && words[1].front() == letter
                          ? parse_number(words[1].substr(1))
                          : std::nullopt;
  if (!factor || found.factor) return refused(line, fmt::format("M852 {}NUMBER once, then M500", letter));
  if (std::abs(*factor) > factor_most)
    return fail(fmt::format("found a factor of {:.3f}, expected -1 to 1", *factor), {line.number, 0});
  found.factor = factor;
  return {};
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  AXIOMETRY_TRY(const char letter, letter_of(options));
  Found found;
  for (const TableLine& line : lines_of(text)) AXIOMETRY_TRY_VOID(take(line, letter, found));
  if (!found.factor || !found.is_kept)
    return fail(fmt::format("found no M852 {}NUMBER with M500 behind it, expected both", letter));
  const auto [low, high] = found.range.value_or(std::pair(-1000.0, 1000.0));
  const std::vector<double> values = {-*found.factor * low * um_per_mm, -*found.factor * high * um_per_mm};
  return AxisCorrection::make(options.kind, {low, high}, values, values);
}

}  // namespace
}  // namespace marlin_skew

const AxisTable marlin_skew_axis_table = {
    .id = "marlin-skew",
    .title = "Marlin, squareness (M852)",
    .extension = ".gcode",
    .curves = TableCurves::both_ways,
    .limits = {.points = 2, .rotary = false, .cross_only = true},
    .uses = {.output_axis = true, .inch = false},
    .sign =
        "A positive factor moves the first axis in the negative direction where the second stands above 0, by the "
        "factor "
        "times that position.",
    .loading =
        "Send the lines in mm (G21); M500 keeps them. M852 is there only when the firmware is built with "
        "SKEW_CORRECTION and "
        "SKEW_CORRECTION_GCODE. I is X over Y, J is X over Z, K is Y over Z: J and K only with SKEW_CORRECTION_FOR_Z. "
        "The "
        "factor replaces the one that M852 says now: set that to 0 before the machine is measured.",
    .verified =
        "The letters of M852, factors from -1 to 1, that a factor times the second position is taken off the first, "
        "and "
        "that J is used less I times K: source of the firmware.",
    .inferred =
        "That positions count from where the firmware has 0. What I times K does to J is left out: it is of second "
        "order. "
        "How it is loaded.",
    .write = marlin_skew::write,
    .read = marlin_skew::read,
    .recognises = [](std::string_view text) { return text.substr(0, 1024).find("\nM852 ") != text.npos; },
};

}  // namespace axiometry::nc
