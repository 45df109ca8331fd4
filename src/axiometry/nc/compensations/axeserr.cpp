// SPDX-License-Identifier: Apache-2.0
//
// axeserr.dat of NcStudio and its relatives: a section for each axis, rows of nominal position, error of the positive
// and of the negative direction in mm.
#include <fmt/format.h>

#include <iterator>
#include <utility>
#include <vector>

#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable axeserr_axis_table;

namespace axeserr {
namespace {

constexpr int decimals_of_error = 4, decimals_of_position = 4;

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, axeserr_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  std::string text = fmt::format("unit = mm\n[{}]\n", options.axis);
  for (std::size_t k = 0; k < correction.positions().size(); ++k)
    fmt::format_to(std::back_inserter(text), "{}, {}, {}\n",
                   fixed_number(correction.positions()[k], decimals_of_position),
                   fixed_number(-1e-3 * correction.values(Direction::up)[k], decimals_of_error),
                   fixed_number(-1e-3 * correction.values(Direction::down)[k], decimals_of_error));
  return text;
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  bool has_unit = false, is_in_section = false, was_in_section = false;
  std::vector<double> positions, up, down;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text);
    if (line.text.empty()) continue;
    if (!has_unit) {
      const auto unit = assignment_of(line.text);
      if (!unit || unit->name != "unit" || unit->value != "mm") return refused(line, "unit = mm");
      has_unit = true;
    } else if (line.text.size() > 2 && line.text.front() == '[' && line.text.back() == ']') {
      is_in_section = text::equal_ignoring_case(line.text.substr(1, line.text.size() - 2), options.axis);
      if (is_in_section && std::exchange(was_in_section, true)) return refused(line, "each axis once");
    } else {
      const auto numbers = numbers_of(line.text, ",");
      if (!numbers || numbers->size() != 3) return refused(line, "NOMINAL, ERROR, ERROR or [AXIS]");
      if (!is_in_section) continue;  // it belongs to another axis
      positions.push_back((*numbers)[0]);
      up.push_back(-1e3 * (*numbers)[1]);
      down.push_back(-1e3 * (*numbers)[2]);
    }
  }
  if (!was_in_section) return fail(fmt::format("found no section [{}], expected one", options.axis));
  return AxisCorrection::make(options.kind, std::move(positions), std::move(up), std::move(down));
}

}  // namespace
}  // namespace axeserr

const AxisTable axeserr_axis_table = {
    .id = "axeserr",
    .title = "NcStudio (Weihong), axeserr.dat",
    .extension = ".dat",
    .curves = TableCurves::each_way,
    .limits = {.rotary = false},
    .uses = {.inch = false},
    .sign = "A positive number moves the axis in the negative direction: it is the error, what is too far.",
    .loading =
        "Put the section of the axis in axeserr.dat in the control's folder, beside those of the other axes, switch "
        "the compensation of lead screw errors on, and start the control anew.",
    .verified =
        "The unit, the sections, the order of the columns, positions that ascend, the sign, that the last column "
        "is of the decreasing direction: a description of the file.",
    .inferred = "That the ends hold; four decimals. How it is loaded.",
    .write = axeserr::write,
    .read = axeserr::read,
    .recognises = [](std::string_view text) { return text.starts_with("unit = mm"); },
};

}  // namespace axiometry::nc
