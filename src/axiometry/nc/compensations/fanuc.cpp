// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/compensations/fanuc_points.h"

namespace axiometry::nc {

extern const AxisTable fanuc_axis_table;
const AxisTable fanuc_axis_table = {
    .id = "fanuc",
    .title = "Fanuc, stored pitch errors, both directions alike",
    .extension = ".txt",
    .curves = TableCurves::both_ways,
    .limits = {.points = 1024, .equidistant = true, .origin = TableOrigin::on_grid, .closes = true},
    .uses =
        {.number = true, .resolution = true, .magnification = true, .largest = true, .inch = false, .told_step = true},
    .sign = fanuc::sign,
    .loading = fanuc::loading,
    .verified = fanuc::verified,
    .inferred = fanuc::inferred,
    .write = [](const AxisCorrection& correction,
                const AxisTableOptions& options) { return fanuc::write(correction, options, fanuc_axis_table, false); },
    .read = [](std::string_view text, const AxisTableOptions& options) { return fanuc::read(text, options, false); },
    .recognises = fanuc::recognises,
};

}  // namespace axiometry::nc
