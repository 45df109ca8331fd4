// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/compensations/linuxcnc_lines.h"

namespace axiometry::nc {

extern const AxisTable linuxcnc_trims_axis_table;
const AxisTable linuxcnc_trims_axis_table = {
    .id = "linuxcnc-type1",
    .title = "LinuxCNC, COMP_FILE_TYPE 1",
    .extension = ".comp",
    .curves = TableCurves::each_way,
    .limits = {.points = linuxcnc::points_most},
    .sign =
        "A number is added to the command (forward, then reverse): a positive one moves the axis in the "
        "positive direction.",
    .loading = linuxcnc::loading,
    .verified =
        "Layout, sign, limits and rule: the sources of LinuxCNC (usrmotintf.cc, command.c, control.c), and "
        "its motion controller run in a test. The sign that its documentation tells for this type is not what "
        "the program does.",
    .inferred = "",
    .write =
        [](const AxisCorrection& correction, const AxisTableOptions& options) {
          return linuxcnc::write(correction, options, linuxcnc_trims_axis_table, linuxcnc::Type::trims);
        },
    .read = [](std::string_view text,
               const AxisTableOptions& options) { return linuxcnc::read(text, options, linuxcnc::Type::trims); },
};

}  // namespace axiometry::nc
