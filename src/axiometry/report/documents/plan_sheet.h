// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "axiometry/model/plan.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

namespace axiometry::report {

/// All that the sheet of a plan is made of.
struct PlanSubject {
  const Plan& plan;
  std::span<const iso230_2::Finding> findings;  ///< plan_findings()
  Duration duration;                            ///< time of the plan alone
  Duration duration_in_all;                     ///< time with its further plans
};

/// A plan as a sheet to take to the machine: programme, targets, findings, and the items of clause 8.1 that only the
/// test itself can fill in. Needs a sound plan.
Document plan_sheet(const PlanSubject& subject, const Options& options);

/// "14 min", "1 h 5 min", "48 s": rounded to what an estimate is worth.
std::string duration_text(Duration duration);

}  // namespace axiometry::report
