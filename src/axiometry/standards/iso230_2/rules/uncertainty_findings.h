// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

namespace axiometry::iso230_2 {

/// What must be known of the uncertainty once its methods have run:
/// - E_VE against the readings: as noise from reading to reading it would scatter them more than they do (WithinRuns,
///   p < 0.001). Where that kind was stated the statement counts no more, and is told as missing; else it is a note.
/// - E_VE as noise that is not small against the scatter, of which Annex A and the GUM see less than it does to A and
/// R;
/// - a Monte Carlo run that states no interval, and why;
/// - a measurand that the method of record does not know: Annex A is for the value of this test.
///
/// The first takes a time that grows with the readings as the Monte Carlo method does, and only where E_VE is stated.
std::vector<Finding> uncertainty_findings(const Test& test, const Assessment& assessment);

}  // namespace axiometry::iso230_2
