// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/compensation/compensation.h"
#include "axiometry/volumetric/field/curve_nodes.h"

namespace axiometry::formats {
namespace {

using volumetric::axis_count;
using volumetric::CurveNode;
using volumetric::ErrorMotion;
using volumetric::motion_count;
using volumetric::Squareness;

constexpr std::string_view general_manual =
    R"(All 21 errors in one table, for programs of one's own: a row for each position, first of X, Y and Z with
their six error motions, then the three squareness errors, the same in every row. Displacements in µm, rotations and
squareness in µrad, names after ISO 230-1. A positive number: the tool, seen from the workpiece, stands too far along
(or is turned too far about) the positive axis. To compensate, it is taken away.

Where errors differ by direction, the rows come twice, behind the word `up` or `down`: an axis came to rest moving to
larger positions, or to smaller ones. Where nothing tells this of some errors, the rows are means of both directions and
the head names these errors. The head says what error of the tool point is left where a program draws straight
lines between the rows. Rotations act from the machine's zero (functional points 0, 0, 0), whatever points the result
states its straightness at.
)";

Result<std::string> write_general(const CompensationRequest& request) {
  AXIOMETRY_TRY(const volumetric::ErrorModel model, errors_for_a_control(request.model));
  const bool has_directions =
      model.coefficients().reversal() != volumetric::Reversal::none && model.unseen_reversals().empty();
  const TableDirections directions = has_directions ? TableDirections::each : TableDirections::means;
  std::string text = "# All 21 errors after ISO 230-1, um and urad\n" + compensation_head(model, "#", directions) +
                     functional_points_text(request.model.machine(), "#");
  text +=
      "# A positive number: the tool, relative to the workpiece, stands too far along (is turned too far about) the\n"
      "# positive axis, actual less commanded. A control that adds what stands here would double the error.\n"
      "# Means of all motions are 0 and straightness is level: constants are a place of the whole machine.\n";
  text += effects_of_all_errors({model, request.tool, request.nodes}, "#", directions);
  if (has_directions) text += "direction,";
  std::array<std::vector<CurveNode>, axis_count * motion_count> curves;
  for (std::size_t a = 0; a < axis_count; ++a) {
    text += fmt::format("{}{}_mm", a == 0 ? "" : ",", "XYZ"[a]);
    for (std::size_t m = 0; m < motion_count; ++m) {
      const ErrorMotion error{a, m};
      text += fmt::format(",{}_{}", volumetric::error_name(error), error.is_rotation() ? "urad" : "um");
      curves[a * motion_count + m] = volumetric::curve_nodes(model, error, request.nodes);
    }
  }
  for (const std::string_view name : volumetric::squareness_names) text += fmt::format(",{}_urad", name);
  text += '\n';
  const auto add_rows = [&](std::string_view before, const auto& value_of) {
    for (std::size_t k = 0; k < request.nodes; ++k) {
      text += before;
      for (std::size_t a = 0; a < axis_count; ++a) {
        text += fmt::format("{}{}", a == 0 ? "" : ",", position_text(curves[a * motion_count][k].position_mm));
        for (std::size_t m = 0; m < motion_count; ++m)
          fmt::format_to(std::back_inserter(text), ",{:.4f}", value_of(curves[a * motion_count + m][k]).value);
      }
      for (std::size_t s = 0; s < volumetric::squareness_names.size(); ++s)
        fmt::format_to(std::back_inserter(text), ",{:.4f}", model.squareness(static_cast<Squareness>(s))->value);
      text += '\n';
    }
  };
  if (!has_directions) {
    add_rows("", [](const CurveNode& node) { return node.mean; });
    return text;
  }
  add_rows("up,", [](const CurveNode& node) { return *node.up; });
  add_rows("down,", [](const CurveNode& node) { return *node.down; });
  return text;
}

}  // namespace

extern const Compensation general_csv_compensation;
const Compensation general_csv_compensation = {
    .id = "general-csv",
    .title = "All 21 errors over the positions of X, Y and Z",
    .takes = "all 21 errors",
    .comment = "#",
    .manual = general_manual,
    .write = write_general,
};

}  // namespace axiometry::formats
