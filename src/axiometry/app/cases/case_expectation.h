// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/cases/case_text.h"
#include "axiometry/app/cases/check.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

/// What an `expect` line of a conformance case says (check.h); private to app/.
namespace axiometry::app {

/// What an operation of a case gave.
struct OperationOutcome {
  Test test;
  iso230_2::Assessment assessment;
};

/// Half width in native units, with the words it was stated in.
struct StatedTolerance {
  double native = 1e-9;
  std::string stated = "1e-9";
};

struct ExpectationContext {
  AxisKind kind = AxisKind::linear;
  StatedTolerance tolerance;
};

/// What the words of an `expect` line after the first say.
std::string expectation_text(const Statement& statement);

/// A number and its unit beginning at the word of this index. Fails on a negative number too.
Result<StatedTolerance> read_tolerance(const Statement& statement, std::size_t index, AxisKind kind);

/// Fails when the line is no expectation.
Result<CaseComparison> check_expectation(const Statement& statement, const Result<OperationOutcome>& outcome,
                                         const ExpectationContext& context);

}  // namespace axiometry::app
