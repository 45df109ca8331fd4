// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "axiometry/uncertainty/sampled_distribution.h"

/// Decisions about conformity to an upper limit in the presence of uncertainty: ISO 14253-1, JCGM 106:2012.
namespace axiometry::uncertainty {

enum class Verdict {
  conforms,          ///< accepted
  does_not_conform,  ///< rejected
  undecided,         ///< the uncertainty reaches over the limit
  not_applicable,    ///< there is no value to judge
};

std::string_view verdict_name(Verdict verdict);  ///< "conforms", "does not conform", "undecided", "not applicable"

/// How an acceptance zone is made from a limit.
struct DecisionRule {
  enum class Kind {
    simple,       ///< accept when y ≤ T, else reject: the uncertainty is shared as the value falls
    iso_14253_1,  ///< guard band g = 1.65 u on either side: accept y ≤ T − g, reject y > T + g, else undecided
    guard_band,   ///< the same with g chosen by the user
  };
  Kind kind = Kind::simple;
  double guard_band = 0.0;  ///< g of a chosen one, in the unit of the value, not below 0

  std::string_view id() const;  ///< "simple", "iso14253-1", "guard-band"
};

/// What is known about the value to be judged.
struct MeasuredValue {
  double value = 0.0;                                              ///< y
  std::optional<double> standard_uncertainty = std::nullopt;       ///< u(y)
  std::optional<SampledDistribution> distribution = std::nullopt;  ///< of a Monte Carlo run; absent: normal, y and u
};

struct Decision {
  Verdict verdict = Verdict::not_applicable;
  double guard_band = 0.0;                       ///< g used
  std::optional<double> probability_conforming;  ///< p_c, JCGM 106, 7; absent without uncertainty
  std::optional<double> consumer_risk;           ///< specific: 1 − p_c when accepted (9.3)
  std::optional<double> producer_risk;           ///< specific: p_c when rejected
};

/// The decision about y ≤ limit. Without uncertainty the two rules with guard bands leave undecided.
Decision decide(const MeasuredValue& measured, double limit, const DecisionRule& rule);

}  // namespace axiometry::uncertainty
