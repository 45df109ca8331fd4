// SPDX-License-Identifier: Apache-2.0
//
// Screw maps of Mach4: what is entered in the dialog of the plug-in, a map for each direction since build 4780.
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable mach4_axis_table;

namespace mach4 {
namespace {

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, mach4_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  const std::vector<double>& positions = correction.positions();
  const double unit = position_per_unit(options);
  const int decimals = table_decimals(options);
  std::string text = comment_lines(";", sign_of(mach4_axis_table, options));
  fmt::format_to(std::back_inserter(text), "Motor of {}\nStart = {}\nLength = {}\nPoints = {}\n", options.axis,
                 trimmed_fixed(positions.front() / unit, decimals),
                 trimmed_fixed((positions.back() - positions.front()) / unit, decimals), positions.size());
  for (const auto& [name, direction] : {std::pair("Positive", Direction::up), std::pair("Negative", Direction::down)}) {
    fmt::format_to(std::back_inserter(text), "Map = {}\n", name);
    for (std::size_t k = 0; k < positions.size(); ++k)
      fmt::format_to(std::back_inserter(text), "{} {}\n", k + 1,
                     fixed_number(correction.values(direction)[k] * unit_per_deviation(options), decimals));
  }
  return text;
}

struct Sheet {
  std::optional<double> start, length, points;
  std::array<std::vector<double>, 2> maps;
  int map = -1;  ///< which of them is read now
};

Result<void> take_assignment(const TableLine& line, const Assignment& a, Sheet& sheet) {
  if (a.name == "Map") {
    if (sheet.map == 1 || a.value != (sheet.map < 0 ? "Positive" : "Negative"))
      return refused(line, "Map = Positive, then Map = Negative");
    ++sheet.map;
    return {};
  }
  std::optional<double>* place = a.name == "Start"    ? &sheet.start
                                 : a.name == "Length" ? &sheet.length
                                 : a.name == "Points" ? &sheet.points
                                                      : nullptr;
  if (!place || *place || sheet.map >= 0) return refused(line, "Start, Length and Points, once, before the maps");
  *place = parse_number(a.value);
  if (!*place) return refused(line, "a number");
  return {};
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  Sheet sheet;
  AxisTableOptions named = options;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text.substr(0, line.text.find(';')));
    if (line.text.empty()) continue;
    if (const auto a = assignment_of(line.text)) {
      AXIOMETRY_TRY_VOID(take_assignment(line, *a, sheet));
      continue;
    }
    if (line.text.starts_with("Motor of ")) {
      if (!is_axis_named(line.text.substr(9), named)) return refused(line, fmt::format("the motor of {}", named.axis));
      continue;
    }
    const auto numbers = sheet.map < 0 ? std::nullopt : numbers_of(line.text);
    std::vector<double>* map = numbers ? &sheet.maps[static_cast<std::size_t>(sheet.map)] : nullptr;
    if (!map || numbers->size() != 2 || (*numbers)[0] != static_cast<double>(map->size() + 1))
      return refused(line, "NAME = VALUE, or the next point and its number");
    map->push_back((*numbers)[1] / unit_per_deviation(options));
  }
  if (!sheet.start || !sheet.length || !sheet.points || !(*sheet.length > 0.0))
    return fail("found no Start, Length above 0 or Points, expected all three");
  for (const std::vector<double>& map : sheet.maps)
    if (map.size() < 2 || static_cast<double>(map.size()) != *sheet.points)
      return fail(fmt::format("found {} points in a map, expected {} (Points), at least 2", map.size(),
                              format_rounded(*sheet.points)));
  const double unit = position_per_unit(options);
  return even_correction(options.kind, *sheet.start * unit, *sheet.length * unit / (*sheet.points - 1.0),
                         std::move(sheet.maps[0]), std::move(sheet.maps[1]));
}

}  // namespace
}  // namespace mach4

const AxisTable mach4_axis_table = {
    .id = "mach4",
    .title = "Mach4, screw mapping",
    .extension = ".txt",
    .curves = TableCurves::each_way,
    .limits = {.equidistant = true, .closes = true},
    .uses = {.turned_sign = true},
    .sign =
        "A positive number moves the axis in the positive direction: it is the expected less the actual position "
        "(inferred).",
    .loading =
        "Enter start, length, number of points and the numbers in the dialog of screw mapping, for each direction "
        "(since build 4780; before it there is one map: ask for one curve for both directions), in the motor's units, "
        "and enable the map.",
    .verified =
        "Start, length, number of points, points at one spacing, one map before build 4780 and two since: the "
        "maker's words.",
    .inferred =
        "The sign: the difference between the expected and the actual is taken in that order. A re-test tells it. "
        "It is a list to enter by hand; no file of it was seen. How it is loaded.",
    .turned_sign =
        "A positive number moves the axis in the negative direction: it is the actual less the expected position "
        "(turned against what was inferred).",
    .write = mach4::write,
    .read = mach4::read,
    .recognises = [](std::string_view text) { return text.substr(0, 512).find("\nMap = Positive") != text.npos; },
};

}  // namespace axiometry::nc
