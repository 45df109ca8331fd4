// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/compensations/linuxcnc_lines.h"

namespace axiometry::nc {

extern const AxisTable linuxcnc_axis_table;
const AxisTable linuxcnc_axis_table = {
    .id = "linuxcnc",
    .title = "LinuxCNC, COMP_FILE_TYPE 0",
    .extension = ".comp",
    .curves = TableCurves::each_way,
    .limits = {.points = linuxcnc::points_most},
    .sign =
        "A number is where the axis really was (forward, then reverse) when the nominal position was "
        "commanded, without the table: one above the nominal moves the axis in the negative direction.",
    .loading = linuxcnc::loading,
    .verified =
        "Layout, sign, limits and rule: the sources of LinuxCNC (usrmotintf.cc, command.c, control.c), and "
        "its motion controller run in a test.",
    .inferred = "",
    .write =
        [](const AxisCorrection& correction, const AxisTableOptions& options) {
          return linuxcnc::write(correction, options, linuxcnc_axis_table, linuxcnc::Type::positions);
        },
    .read = [](std::string_view text,
               const AxisTableOptions& options) { return linuxcnc::read(text, options, linuxcnc::Type::positions); },
};

}  // namespace axiometry::nc
