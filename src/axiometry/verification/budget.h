// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/verification/clause3.h"
#include "axiometry/verification/ledger.h"

/// Annex A once more, (A.1) to (A.19), from the inputs that the budget states.
namespace axiometry::verification {

/// U of a mean deviation, and what of it is U_EVE.
struct ExactMean {
  Exact environment;
  Exact U;  ///< absent where there is no such mean
};

/// The mean deviations of a target (docs/theory/annex-a.md).
struct ExactMeans {
  Exact length_m;                    ///< l_i; absent of rotary axes
  std::vector<Exact> contributions;  ///< contributions of the lines of the budget that have a U, but for U_EVE, at l_i
  ExactMean up, down, mean;
};

/// What Annex A makes of a test.
struct ExactAnnexA {
  ExactParameters U;  ///< expanded, k = 2
  Exact U_eve;
  std::vector<ExactMeans> means;  ///< one for each target; empty where the result states none
};

/// Recomputes every line of `uncertainty.annex_a_budget` of a result (docs/results.md) and compares it, then combines
/// them, for the parameters and for the means of every target. A line whose formula is not one of the annex is taken as
/// it is stated and counted as compared. `measured` tells which parameters exist, `positions` how often each target was
/// approached and what the measured travel is, where that stands for L.
ExactAnnexA check_budget(const json::Value& budget, const ExactParameters& measured,
                         std::span<const ExactPosition> positions, Ledger& ledger);

/// A member that is a number.
std::optional<double> number_member(const json::Value* object, std::string_view name);
/// A member that is words; empty when it is not.
std::string_view text_member(const json::Value* object, std::string_view name);
/// A member of any kind but null.
const json::Value* present_value(const json::Value* object, std::string_view name);

}  // namespace axiometry::verification
