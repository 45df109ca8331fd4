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
/// which follow from those beside them.
std::vector<NamedFinding> findings_of_table(const Series& series, const AxisCorrection& correction);

/// Of a re-test: "did what it should", or what went wrong instead: a sign mistake (the error doubled), a table that was
/// not active, one that was added twice, directions that were exchanged, a reversal that is corrected twice. Of a
/// control whose sign was inferred a sign mistake names the way out.
NamedFinding finding_of_retest(const Effect& effect, bool sign_inferred = false);

}  // namespace axiometry::compensation
