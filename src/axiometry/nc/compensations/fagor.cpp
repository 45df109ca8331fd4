// SPDX-License-Identifier: Apache-2.0
//
// Leadscrew compensation of the Fagor 8055: points of any spacing with an error for each direction; where those of the
// negative direction are all 0, the positive ones serve both.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable fagor_axis_table;

namespace fagor {
namespace {

int decimals_of(const AxisTableOptions& options) { return options.kind == AxisKind::linear && options.in_inch ? 5 : 4; }

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, fagor_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  const int decimals = decimals_of(options);
  const auto error = [&](std::size_t k, Direction direction) {
    return fixed_number(-correction.values(direction)[k] * unit_per_deviation(options), decimals);
  };
  const std::size_t count = correction.positions().size();
  const std::string zero = fixed_number(0.0, decimals);
  std::vector<std::string> down(count);
  for (std::size_t k = 0; k < count; ++k) down[k] = correction.same_both_ways() ? zero : error(k, Direction::down);
  if (!correction.same_both_ways() && std::ranges::all_of(down, [&](const std::string& x) { return x == zero; }))
    return fail(
        "found no error in the negative direction at all, which the 8055 takes for that of the positive one, "
        "expected one of 0.0001 at least");
  std::string text = fmt::format("; {} LSCRWCOM (P15) = ON, NPOINTS (P16) = {}\n", options.axis, count) +
                     comment_lines(";", sign_of(fagor_axis_table, options));
  for (std::size_t k = 0; k < count; ++k)
    fmt::format_to(std::back_inserter(text), "P{:03} {} {} {}\n", k + 1,
                   fixed_number(correction.positions()[k] / position_per_unit(options), decimals),
                   error(k, Direction::up), down[k]);
  return text;
}

/// "; X LSCRWCOM (P15) = …" names the axis.
Result<void> check_head(const TableLine& line, AxisTableOptions& options) {
  const std::vector<std::string_view> words = text::words(line.text);
  if (words.size() < 3 || words[0] != ";" || words[2] != "LSCRWCOM") return {};
  return check_axis_named(words[1], options, line);
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  std::vector<double> positions, up, down;
  AxisTableOptions named = options;
  for (TableLine line : lines_of(text)) {
    AXIOMETRY_TRY_VOID(check_head(line, named));
    line.text = text::trim(line.text.substr(0, line.text.find(';')));
    if (line.text.empty()) continue;
    const std::size_t blank = line.text.find(' ');
    const auto number = line.text.starts_with('P') && blank != std::string_view::npos
                            ? whole_number(line.text.substr(1, blank - 1))
                            : std::nullopt;
    const auto numbers = number ? numbers_of(line.text.substr(blank)) : std::nullopt;
    if (!numbers || numbers->size() != 3 || *number != std::ssize(positions) + 1)
      return refused(line, fmt::format("P{:03} POSITION ERROR ERROR", positions.size() + 1));
    if (positions.size() == fagor_axis_table.limits.points)
      return refused(line, fmt::format("at most {} points", fagor_axis_table.limits.points));
    positions.push_back((*numbers)[0] * position_per_unit(options));
    up.push_back(-(*numbers)[1] / unit_per_deviation(options));
    down.push_back(-(*numbers)[2] / unit_per_deviation(options));
  }
  if (std::ranges::all_of(down, [](double x) { return x == 0.0; })) down = up;
  return AxisCorrection::make(options.kind, std::move(positions), std::move(up), std::move(down));
}

}  // namespace
}  // namespace fagor

const AxisTable fagor_axis_table = {
    .id = "fagor",
    .title = "Fagor 8055, leadscrew compensation",
    .extension = ".txt",
    .curves = TableCurves::each_way,
    .limits = {.points = 1000, .closes = true},
    .uses = {.turned_sign = true},
    .sign = "A positive number moves the axis in the negative direction: it is the error, what is too far (inferred).",
    .loading =
        "Set P15 (LSCRWCOM) of the axis to ON and P16 (NPOINTS) to the number of points, enter the points in the "
        "table of leadscrew errors, and reset the control. Positions are from machine zero.",
    .verified =
        "P15, P16, at most 1000 points, one error for each direction, that zeros in the negative direction mean the "
        "same as in the positive one, that 0 and 360 degrees are equal: the manual.",
    .inferred =
        "That the error is actual less commanded, as the manual's word for it says. It is a list to enter by hand; "
        "the layout of a file was not seen. How it is loaded.",
    .turned_sign =
        "A positive number moves the axis in the positive direction: it is what is too short (turned against what was "
        "inferred).",
    .write = fagor::write,
    .read = fagor::read,
    .recognises = [](std::string_view text) { return text.substr(0, 128).find("LSCRWCOM") != text.npos; },
};

}  // namespace axiometry::nc
