// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <iterator>

#include "axiometry/base/number_text.h"
#include "axiometry/formats/compensation/compensation.h"
#include "axiometry/volumetric/field/axis_tables.h"

namespace axiometry::formats {
namespace {

constexpr std::string_view axis_manual =
    R"(One table for each axis, for controls that compensate positioning alone: the deviation along the axis over its
position, on the line through the middle of the volume with one tool, which is what serves the whole volume best.

Its head says how large the error of the tool point was and how large it stays: straightness, squareness and what
rotations do away from the middle remain. A positive number: the axis goes too far; to compensate, it is taken away.
What a certain control wants beside (intervals, increments, its sign) is not said here.
)";

Result<std::string> write_axis(const CompensationRequest& request) {
  const volumetric::ErrorModel& model = request.model;
  const volumetric::Tool& tool = model.machine().tools[request.tool];
  const auto tables = volumetric::axis_tables(model, tool.offset_mm, request.nodes);
  if (!tables)
    return fail(
        "found that the lengths do not tell the error of the tool point with this tool, expected all of it: a "
        "control would take a number that nobody measured");
  std::string text =
      "# Deviations of positioning, for controls that compensate each axis alone, um\n" + compensation_head(model, "#");
  fmt::format_to(
      std::back_inserter(text),
      "# Tool at {} {} {} mm from where the axes stand; lines through the middle of the volume\n"
      "# A positive number: the axis goes too far, actual less commanded. A control that adds what stands here\n"
      "# would double the error.\n"
      "# Error of the tool point without rigid motion, um:  largest  95 %  mean\n"
      "#   before                                           {:8.1f} {:5.1f} {:5.1f}\n"
      "#   with these tables, predicted                     {:8.1f} {:5.1f} {:5.1f}\n",
      format_exact(tool.offset_mm.x), format_exact(tool.offset_mm.y), format_exact(tool.offset_mm.z),
      tables->before.largest.value, tables->before.percent_95, tables->before.mean, tables->after.largest.value,
      tables->after.percent_95, tables->after.mean);
  text += "axis,position_mm,deviation_um,u_um\n";
  for (std::size_t a = 0; a < volumetric::axis_count; ++a)
    for (const volumetric::AxisTableNode& node : tables->axes[a])
      fmt::format_to(std::back_inserter(text), "{},{},{:.4f},{:.4f}\n", "XYZ"[a], position_text(node.position_mm),
                     node.deviation.value, node.deviation.u);
  return text;
}

}  // namespace

extern const Compensation axis_csv_compensation;
const Compensation axis_csv_compensation = {
    .id = "axis-csv",
    .title = "Positioning of each axis alone",
    .takes = "positioning",
    .of_one_tool = true,
    .manual = axis_manual,
    .write = write_axis,
};

}  // namespace axiometry::formats
