// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/model/axis_correction.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/nc/axis_table.h"

/// What must be done at the control beside loading a table, and what of it only a re-test tells.
namespace axiometry::app {

/// `count_said`: somebody stated what one count of the control is, so that the usual one is not assumed.
std::vector<NamedFinding> findings_of_control(const nc::AxisTable& control, const nc::AxisTableOptions& options,
                                              const AxisCorrection& applied, bool count_said);

}  // namespace axiometry::app
