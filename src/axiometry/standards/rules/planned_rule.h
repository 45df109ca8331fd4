// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/standards/rules/rule.h"

/// The cycle of another rule in a plan after ISO 230-2:2014: what the rule asks for beyond it, where the user asks for
/// nothing else.
namespace axiometry::standards {

/// Its approaches at least, its targets and steps, and its order in place of the standard test cycle. Fails on a rotary
/// axis where the rule is of linear ones only, on errors other than positions and on the test for a periodic error, of
/// which no rule says anything.
Result<iso230_2::PlanRequest> with_cycle_of(const AxisRule& rule, iso230_2::PlanRequest request);

/// What the rule says of a plan, as of a test that followed it and found no deviation: notes, for that the plan is in
/// accordance with ISO 230-2:2014 is another question. The first says on what it rests. Needs a sound plan.
std::vector<iso230_2::Finding> planned_rule_findings(const AxisRule& rule, const Plan& plan);

}  // namespace axiometry::standards
