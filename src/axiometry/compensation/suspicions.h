// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/compensation/fit.h"
#include "axiometry/compensation/prediction.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/model/series.h"

/// What speaks against a table, in words that a person at the machine understands.
namespace axiometry::compensation {

/// Fails where the deviations grow with the travel as no axis does (above 1 %): the readings ran against the axis, or
/// one of both is in inches, or they are no deviations.
Result<void> check_plausible(const Series& series, AxisKind kind);

/// Of the readings: outliers in a mean, with what they do to it; a direction that was not measured; runs that drift;
/// fewer targets or approaches than a mean and what lies between them want; a rotary axis whose ends, a whole turn
/// apart, differ.
std::vector<NamedFinding> findings_of_readings(const Series& series, AxisKind kind, TableCurves curves);

/// Of a table: what lies beyond its ends, of what was measured; positions without a target between their neighbours,
/// which follow from those beside them. A control that rolls over does not hold the last value beyond the ends, so its
/// file does itself as far as there are targets.
std::vector<NamedFinding> findings_of_table(const Series& series, const AxisCorrection& correction,
                                            bool rolls_over = false);

}  // namespace axiometry::compensation
