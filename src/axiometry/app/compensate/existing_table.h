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

/// What positions beyond those that were asked for a control's tables have, with the value of the last one of these.
struct LeadOn {
  double reference = 0.0;     ///< they reach it, and one step beyond
  bool over_targets = false;  ///< and the first step that no target is beyond, where they do not hold their ends
};
/// Without them: the same correction, at the positions that were asked for when it was made.
Result<AxisCorrection> without_lead_to(LeadOn lead, AxisCorrection existing, const Series& series);

/// Fails where targets lie beyond the ends of a table that rolls over there: what it did to them is not in it as read.
Result<void> check_over_targets(const AxisCorrection& existing, const Series& series);

/// Fails where a table goes beyond the targets, naming what can be asked for instead of its positions.
Result<void> check_within_targets(const AxisCorrection& existing, const Series& series);

/// Its curve alone. What its number for the reversal asked for is in what the control had during the test, from where
/// the new table's number counts: so it is right whether or not the old one was ever set, and of a table that was read
/// off a control, which has none.
Result<AxisCorrection> without_number_beside(const AxisCorrection& existing);

/// Where the new table ends within the old one, which then corrects nothing there any more.
std::optional<NamedFinding> finding_of_cut_table(const AxisCorrection& existing, const std::vector<double>& nodes);

}  // namespace axiometry::app
