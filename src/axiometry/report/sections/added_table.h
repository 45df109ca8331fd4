// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/model/axis_correction.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// What a control adds at the positions of its table, up and down, µm or ″. Of a table with more than `rows_most`
/// positions (2 at least) each so many-th is shown, and the last, and a note says where all are. `rolls_over`: beyond
/// its ends the control goes on to the other one.
Table added_table(const AxisCorrection& applied, std::size_t rows_most, bool rolls_over, const Options& options);

}  // namespace axiometry::report
