// SPDX-License-Identifier: Apache-2.0
//
// Screw mapping of KMotion (KFLOP): how many points, their spacing, where the first one is, then of each point what
// must be commanded for the axis to be there.
#include <fmt/format.h>

#include <iterator>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable kflop_axis_table;

namespace kflop {
namespace {

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, kflop_axis_table));
  const std::vector<double>& positions = correction.positions();
  const auto step = common_step(positions);
  AXIOMETRY_CONTRACT(step);  // check_limits()
  const double unit = position_per_unit(options);
  const int decimals = table_decimals(options);
  std::string text = fmt::format("{}\n{}\n{}\n", positions.size(), trimmed_fixed(*step / unit, decimals + 2),
                                 trimmed_fixed(positions.front() / unit, decimals));
  for (std::size_t k = 0; k < positions.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{},{}\n", k,
                   fixed_number(positions[k] / unit + correction.values(Direction::up)[k] * unit_per_deviation(options),
                                decimals));
  return text;
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  std::vector<double> head, commands;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text);
    const auto numbers = numbers_of(line.text, ",");
    if (head.size() < 3) {
      if (!numbers || numbers->size() != 1)
        return refused(line, "the number of points, the spacing, the offset, a line each");
      head.push_back(numbers->front());
      continue;
    }
    if (!numbers || numbers->size() != 2 || (*numbers)[0] != static_cast<double>(commands.size()))
      return refused(line, fmt::format("{},COMMANDED", commands.size()));
    commands.push_back((*numbers)[1]);
  }
  if (head.size() < 3 || head[0] != static_cast<double>(commands.size()) || !(head[1] > 0.0))
    return fail(
        fmt::format("found {} points, expected the number in the first line, and a spacing above 0 in the second",
                    commands.size()));
  std::vector<double> up;
  for (std::size_t k = 0; k < commands.size(); ++k)
    up.push_back((commands[k] - (head[2] + head[1] * static_cast<double>(k))) / unit_per_deviation(options));
  std::vector<double> down = up;
  const double unit = position_per_unit(options);
  return even_correction(options.kind, head[2] * unit, head[1] * unit, std::move(up), std::move(down));
}

}  // namespace
}  // namespace kflop

const AxisTable kflop_axis_table = {
    .id = "kflop",
    .title = "KFLOP with KMotionCNC, screw mapping",
    .extension = ".txt",
    .curves = TableCurves::both_ways,
    .limits = {.equidistant = true, .closes = true},
    .sign =
        "A number is the position that must be commanded for the axis to be at the point: one above the point moves "
        "the axis in the positive direction.",
    .loading =
        "Name the file in the settings of KMotionCNC's motion planner for this axis, in the units of the table, and "
        "initialise anew. One curve serves both directions.",
    .verified =
        "The lines: number of points, spacing, offset, then index and command; that it is the command that is "
        "needed, in one direction: the maker's wiki and forum.",
    .inferred = "That the offset is the position of the first point, and that the ends hold. How it is loaded.",
    .write = kflop::write,
    .read = kflop::read,
};

}  // namespace axiometry::nc
