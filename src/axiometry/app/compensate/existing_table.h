// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis_correction.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/model/series.h"

/// What speaks against a table that was active while a test was measured, beside what a control would refuse.
namespace axiometry::app {

/// Fails where a table of a linear axis covers little of the targets' range, and would cover most of it in the other
/// unit of length: it is in mm and was read as inches (`in_inch`), or the other way round.
Result<void> check_unit_of_length(const AxisCorrection& existing, const Series& series, bool in_inch);

/// Without the positions beyond the targets that only lead on to the reference point of a control whose tables reach
/// it, and one step beyond: with the value of the last one within, which the control holds there anyway. The same
/// correction, at the positions that were asked for when it was made.
Result<AxisCorrection> without_lead_to(double reference, AxisCorrection existing, const Series& series);

/// Fails where a table goes beyond the targets, naming what can be asked for instead of its positions.
Result<void> check_within_targets(const AxisCorrection& existing, const Series& series);

/// Its curve alone. What its number for the reversal asked for is in what the control had during the test, from where
/// the new table's number counts: so it is right whether or not the old one was ever set, and of a table that was read
/// off a control, which has none.
Result<AxisCorrection> without_number_beside(const AxisCorrection& existing);

/// Where the new table ends within the old one, which then corrects nothing there any more.
std::optional<NamedFinding> finding_of_cut_table(const AxisCorrection& existing, const std::vector<double>& nodes);

}  // namespace axiometry::app
