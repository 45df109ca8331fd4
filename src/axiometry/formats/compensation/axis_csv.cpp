// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <iterator>

#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/compensation/compensation.h"
#include "axiometry/volumetric/field/axis_tables.h"

namespace axiometry::formats {
namespace {

constexpr std::string_view axis_manual =
    R"(One table for each axis, for controls that compensate positioning alone: the deviation along the axis over its
position, on the line through the middle of the volume with one tool, which is what serves the whole volume best.

Where errors differ by direction, the deviations of each stand behind their means (up: the axis came to rest moving to
larger positions), unless nothing tells this of some of them: then the head names these, and there are means alone. The
head says how large the error of the tool point was and how large it stays: straightness,
squareness and what rotations do away from the middle remain. A positive number: the axis goes too far; to compensate,
it is taken away. What a certain control wants beside (intervals, increments, its sign) is not said here.
)";

Result<std::string> write_axis(const CompensationRequest& request) {
  const volumetric::ErrorModel& model = request.model;
  const volumetric::Tool& tool = model.machine().tools[request.tool];
  const auto tables = volumetric::axis_tables(model, tool.offset_mm, request.nodes);
  if (!tables)
    return fail(
        "found that the readings do not tell the error of the tool point with this tool, expected all of it: a "
        "control would take a number that nobody measured");
  const bool has_directions = tables->has_directions;
  std::string text = "# Deviations of positioning, for controls that compensate each axis alone, um\n" +
                     compensation_head(model, "#", has_directions ? TableDirections::each : TableDirections::means);
  fmt::format_to(
      std::back_inserter(text),
      "# Tool at {} {} {} mm from where the axes stand; lines through the middle of the volume\n"
      "# A positive number: the axis goes too far, actual less commanded. A control that adds what stands here\n"
      "# would double the error.\n",
      format_exact(tool.offset_mm.x), format_exact(tool.offset_mm.y), format_exact(tool.offset_mm.z));
  text += effect_text(model, "#", tool, tables->effect, TableDirections::means);
  text += has_directions ? "axis,position_mm,deviation_um,u_um,up_um,up_u_um,down_um,down_u_um\n"
                         : "axis,position_mm,deviation_um,u_um\n";
  for (std::size_t a = 0; a < volumetric::axis_count; ++a)
    for (const volumetric::AxisTableNode& node : tables->axes[a]) {
      fmt::format_to(std::back_inserter(text), "{},{},{:.4f},{:.4f}", "XYZ"[a], position_text(node.position_mm),
                     node.deviation.value, node.deviation.u);
      if (has_directions)
        fmt::format_to(std::back_inserter(text), ",{:.4f},{:.4f},{:.4f},{:.4f}", node.up.value, node.up.u,
                       node.down.value, node.down.u);
      text += '\n';
    }
  return text;
}

}  // namespace

extern const Compensation axis_csv_compensation;
const Compensation axis_csv_compensation = {
    .id = "axis-csv",
    .title = "Positioning of each axis alone",
    .takes = "positioning",
    .of_one_tool = true,
    .comment = "#",
    .manual = axis_manual,
    .write = write_axis,
};

}  // namespace axiometry::formats
