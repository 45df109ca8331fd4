// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/compensations/fanuc_points.h"

namespace axiometry::nc {

extern const AxisTable fanuc_bidirectional_axis_table;
const AxisTable fanuc_bidirectional_axis_table = {
    .id = "fanuc-bidirectional",
    .title = "Fanuc, stored pitch errors of each direction",
    .extension = ".txt",
    .curves = TableCurves::each_way,
    .limits =
        {.points = 1024, .equidistant = true, .origin = TableOrigin::on_grid, .zero_upwards = true, .closes = true},
    .uses = {.number = true, .resolution = true, .magnification = true, .largest = true, .inch = false},
    .sign = fanuc::sign,
    .loading = fanuc::loading,
    .verified = fanuc::verified,
    .inferred = fanuc::inferred_of_each_way,
    .write =
        [](const AxisCorrection& correction, const AxisTableOptions& options) {
          return fanuc::write(correction, options, fanuc_bidirectional_axis_table, true);
        },
    .read = [](std::string_view text, const AxisTableOptions& options) { return fanuc::read(text, options, true); },
    .recognises = fanuc::recognises,
};

}  // namespace axiometry::nc
