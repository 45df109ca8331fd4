// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "axiometry/uncertainty/belief.h"

/// Decisions about conformity to an upper limit in the presence of uncertainty: ISO 14253-1, JCGM 106:2012.
namespace axiometry::uncertainty {

enum class Verdict {
  conforms,          ///< accepted
  does_not_conform,  ///< rejected
  undecided,         ///< the uncertainty reaches over the limit
  not_applicable,    ///< there is no value to judge
};

std::string_view verdict_name(Verdict verdict);  ///< "conforms", "does not conform", "undecided", "not applicable"

/// With this probability a verdict of ISO 14253-1 must be right, on either side.
inline constexpr double decision_probability = 0.95;

/// How an acceptance zone is made from a limit.
struct DecisionRule {
  enum class Kind {
    simple,       ///< accept when y ≤ T, else reject: the uncertainty is shared as the value falls
    iso_14253_1,  ///< accept when P(Y ≤ T) ≥ 95 %, reject when P(Y > T) ≥ 95 %, else undecided
    guard_band,   ///< accept when y ≤ T − g, reject when y > T + g, else undecided, with g chosen by the user
  };
  Kind kind = Kind::simple;
  double guard_band = 0.0;  ///< g of a chosen one, in the unit of the value, not below 0

  std::string_view id() const;  ///< "simple", "iso14253-1", "guard-band"
};

/// What is known about the value to be judged.
struct MeasuredValue {
  double value = 0.0;                           ///< y, with its sign where `either_sign`
  std::optional<Belief> belief = std::nullopt;  ///< what is believed of Y about that value; absent: nothing is known
  bool either_sign = false;                     ///< whether the limit is one of the magnitude: −T ≤ Y ≤ T
  double rounding = 0.0;                        ///< |y − what the decimals of the data say|, at most
};

/// A decision and the zones that it follows from: y is accepted up to T − g_accept and rejected above T + g_reject.
/// The zones are those of values with the same doubt, wherever they lie, so that verdict, probability and zones agree.
struct Decision {
  Verdict verdict = Verdict::not_applicable;
  double guard_band = 0.0;      ///< g_accept; for a normal Y under ISO 14253-1 1.645 u
  double rejection_band = 0.0;  ///< g_reject; the same number where the doubt is symmetric
  /// p_c, JCGM 106, 7; absent without a belief. Under ISO 14253-1 it is 95 % or more exactly where the verdict is
  /// `conforms`, and 5 % or less exactly where it is `does_not_conform`.
  std::optional<double> probability_conforming;
  std::optional<Range> probability_range;  ///< range of p_c over all that is held possible
  std::optional<double> consumer_risk;     ///< specific, at most: 1 − p_c when accepted (9.3)
  std::optional<double> producer_risk;     ///< specific, at most: p_c when rejected
};

/// The decision about y ≤ limit. Without a belief the two rules with guard bands leave undecided. A value at its limit
/// conforms: y counts as at it when it is no farther above than `rounding`.
///
/// For a given y, more doubt never makes a rejected value an accepted one, nor the other way round: what is accepted
/// has y ≤ T, what is rejected y > T, whatever the belief.
Decision decide(const MeasuredValue& measured, double limit, const DecisionRule& rule);

}  // namespace axiometry::uncertainty
