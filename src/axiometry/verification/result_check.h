// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/series.h"
#include "axiometry/verification/budget.h"
#include "axiometry/verification/clause3.h"
#include "axiometry/verification/evidence.h"
#include "axiometry/verification/ledger.h"

namespace axiometry::verification {

/// All that was found again of a test, for whatever shows it.
struct Found {
  std::vector<ExactPosition> positions;
  ExactParameters parameters;
  Interval rounding;  ///< how far printed figures may be from these
  ExactAnnexA annex_a;
  std::vector<ExactPosition> corrected_positions;  ///< (A.10), where the result has it
  ExactParameters corrected;
};

/// Computes clause 3 again from the readings and Annex A from the inputs that the result states, decides again, and
/// compares every figure of the result of `axiometry evaluate --json` (docs/results.md) with what was found. What comes
/// from the GUM and Monte Carlo methods is compared where the result has it twice, and not computed again. A result
/// without parameters is a difference, without another member says nothing about it. Throws when numbers are beyond the
/// arithmetic (exact.h).
Found check_result(const json::Value& result, const Evidence& evidence, Ledger& ledger);

}  // namespace axiometry::verification
