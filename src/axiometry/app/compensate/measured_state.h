// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis_correction.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/model/test.h"

/// What a test says of itself that speaks against a table of its readings: a table corrects whatever is in them, be it
/// of the axis or not.
namespace axiometry::app {

/// Fails where the instrument's sign is said to be reversed and was not corrected, so that a table would double the
/// error; and on a line in space that is not along one axis, which no table of an axis corrects.
Result<void> check_measures_axis(const Test& test);

/// Of a table that is kept since before check_measures_axis() failed with this.
NamedFinding finding_of_kept_table(const Error& why_not_made);

/// Of the test a table is made of, each serious: labels of direction that its rows contradict, unless the table has one
/// curve for both; effects on the readings that the metadata tell of and nothing was done about
/// (uncorrected_effects.h); a compensation that was active, and no table to count from (`table_given`), or the reverse.
std::vector<NamedFinding> findings_of_state(const Test& test, TableCurves curves, bool table_given);

/// Of its re-test: another axis or machine, or an earlier day, than the test states (`before`); such labels and
/// effects; and that it states no table was active.
std::vector<NamedFinding> findings_of_retest_state(const Metadata& before, const Test& retest);

/// Fails where both are one file with the same readings: it proves nothing. Several tests of one file are none such.
Result<void> check_not_itself(const Test& test, const Test& retest);

}  // namespace axiometry::app
