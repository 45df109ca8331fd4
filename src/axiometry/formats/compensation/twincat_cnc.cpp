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

using volumetric::CurveNode;
using volumetric::ErrorMotion;
using volumetric::motion_count;
using volumetric::Squareness;

constexpr std::string_view twincat_manual =
    R"(The table of errors that the volumetric compensation of ISG kernels reads, Beckhoff's TwinCAT CNC (TF5280) among
them: for each axis a header of its name and its errors, rows of numbers, `#` between the tables; mm and rad.

- Verified in descriptions: headers of arguments and errors, comments behind `//`, `#` as a break, mm and rad, the names
  after ISO 230-1.
- Inferred: that squareness may stand as a column that is the same at every position of its axis, and that a positive
  number is actual less commanded, as in the kernel's tables of single axes. Never tried on a control.
- What the control asks for beside (`chain`, `workpiece_axes`, `negate`) is in the head of the file. Measure one line
  again after loading: a doubled error means that `negate` is the other way round.
)";

void write_table(std::string& text, const volumetric::ErrorModel& model, std::size_t axis, std::size_t nodes) {
  constexpr std::array<std::array<int, 2>, 3> squareness_of = {{{-1, -1}, {0, -1}, {1, 2}}};  // X; C0Y; B0Z, A0Z
  std::vector<std::vector<CurveNode>> curves;
  text += "XYZ"[axis];
  for (std::size_t m = 0; m < motion_count; ++m) {
    text += fmt::format(" {}", volumetric::error_name({axis, m}));
    curves.push_back(volumetric::curve_nodes(model, {axis, m}, nodes));
  }
  std::string constants;
  for (const int s : squareness_of[axis]) {
    if (s < 0) continue;
    text += fmt::format(" {}", volumetric::squareness_names[static_cast<std::size_t>(s)]);
    constants += fmt::format(" {:.9f}", 1e-6 * model.squareness(static_cast<Squareness>(s))->value);
  }
  text += '\n';
  for (std::size_t k = 0; k < nodes; ++k) {
    fmt::format_to(std::back_inserter(text), "{:.4f}", curves[0][k].position_mm);
    for (std::size_t m = 0; m < motion_count; ++m) {
      const double value = curves[m][k].mean.value;
      if (m < volumetric::first_rotation)
        fmt::format_to(std::back_inserter(text), " {:.7f}", 1e-3 * value);
      else
        fmt::format_to(std::back_inserter(text), " {:.9f}", 1e-6 * value);
    }
    text += constants + '\n';
  }
}

Result<std::string> write_twincat(const CompensationRequest& request) {
  AXIOMETRY_TRY(const volumetric::ErrorModel model, errors_for_a_control(request.model));
  const auto& chain = model.machine().chain;
  std::string order, workpiece;
  for (const std::size_t a : chain.order()) {
    order += "XYZ"[a];
    if (chain.carries_workpiece(a)) workpiece += "XYZ"[a];
  }
  std::string text = "// Volumetric errors for ISG kernels and TwinCAT CNC (TF5280), mm and rad\n" +
                     compensation_head(model, "//", TableDirections::means) +
                     functional_points_text(request.model.machine(), "//");
  fmt::format_to(
      std::back_inserter(text),
      "// chain, workpiece to tool: {}; workpiece_axes: {}\n"
      "// A positive number: the tool, relative to the workpiece, stands too far along (is turned too far "
      "about)\n"
      "// the positive axis, actual less commanded, also of axes that carry the workpiece.\n"
      "// Verified: layout, names, units. Inferred: the sign that the control expects (negate) and that\n"
      "// squareness may stand as a constant column. Measure a line again: a doubled error means the sign.\n",
      order, workpiece.empty() ? "none" : workpiece);
  text += effects_of_all_errors({model, request.tool, request.nodes}, "//", TableDirections::means);
  for (std::size_t a = 0; a < volumetric::axis_count; ++a) {
    if (a > 0) text += "#\n";
    write_table(text, model, a, request.nodes);
  }
  return text;
}

}  // namespace

extern const Compensation twincat_cnc_compensation;
const Compensation twincat_cnc_compensation = {
    .id = "twincat-cnc",
    .title = "Beckhoff TwinCAT CNC TF5280 and ISG kernels",
    .takes = "all 21 errors",
    .comment = "//",
    .manual = twincat_manual,
    .write = write_twincat,
};

}  // namespace axiometry::formats
