// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/model/axis_correction.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/nc/axis_table.h"

/// What must be done at the control beside loading a table, and what of it only a re-test tells.
namespace axiometry::app {

/// Of what one count of the control is.
struct CountStanding {
  bool said = false;      ///< somebody stated it, so that the usual one is not assumed
  bool was_read = false;  ///< a table that was active was read with it
};

std::vector<NamedFinding> findings_of_control(const nc::AxisTable& control, const nc::AxisTableOptions& options,
                                              const AxisCorrection& applied, const CountStanding& count);

}  // namespace axiometry::app
