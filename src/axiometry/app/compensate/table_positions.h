// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/compensation/grid.h"
#include "axiometry/model/series.h"
#include "axiometry/nc/axis_table.h"

namespace axiometry::app {

/// Whether somebody says anything of where a table has its positions.
bool is_wished(const compensation::GridRequest& grid);

/// Positions of a table of a control, mm or °, for targets that are known: as grid_of(), with the control's limits and
/// what it wants of the reference point; of a control without tables the reference point, or both ends. Fails as that.
Result<std::vector<double>> table_positions(const nc::AxisTable& control, double reference,
                                            const compensation::GridRequest& wished,
                                            const std::vector<double>& targets);

/// The file of a control. Where it does not hold its ends but rolls over to the other one, the table has the value of
/// each end at as many steps more as there are targets beyond it. Fails as nc::write_table().
Result<std::string> write_over_targets(const nc::AxisTable& control, const AxisCorrection& correction,
                                       const Series& series, const nc::AxisTableOptions& options);

}  // namespace axiometry::app
