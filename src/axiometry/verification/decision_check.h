// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/verification/clause3.h"
#include "axiometry/verification/evidence.h"
#include "axiometry/verification/ledger.h"

/// The decisions about limits once more: ISO 14253-1, JCGM 106:2012.
namespace axiometry::verification {

/// What a decision is made from.
struct Known {
  const ExactParameters& measured;
  const Interval& rounding;  ///< rounding of the parameters, rounding_of()
  const Drawn& drawn;
  std::span<const ExactPosition> positions{};  ///< positions that the parameters were taken over
  std::string_view type_a{};                   ///< how the Monte Carlo run sampled the approaches; empty: it did not
};

/// Decides every row of `tolerances` of a result (docs/results.md) again and compares verdict, probability, risks and
/// limits; then `overall`, the verdict on all of them. Rules:
///
/// - simple: y ≤ T. guard-band: conforms y ≤ T − g, does not conform y > T + g.
/// - iso14253-1: conforms where P(Y ≤ T) ≥ 0.95, does not conform where P(Y > T) ≥ 0.95. Y is normal about the value
///   (after Student's t where the row has degrees of freedom), or as a Monte Carlo run drew it: then by each of the
///   distributions held possible. What conforms has y ≤ T, what does not y > T.
/// - Of B̄ the magnitude counts: y = |B̄|, P(−T ≤ Y ≤ T).
/// - y = T is decided by decimals for parameters without roots. With roots a value up to 1e-9 of itself above its limit
///   may count as at it; of a probability within 1e-9 of 0.95 both decisions are right.
/// - By an interval that held the truth less often than it states (docs/studies/coverage.md: `t-scaled` but for B̄,
///   `resampled`) nothing is decided that asks for an uncertainty, and no probability is stated.
/// - A row that is withheld (a known effect is not corrected) is undecided whatever its numbers are.
/// - A value of which some target lacks a term is a lower bound: it never conforms. B̄ of a part of the targets is
///   decided neither way.
void check_decisions(const json::Value& rows, std::string_view overall, const Known& known, Ledger& ledger);

}  // namespace axiometry::verification
