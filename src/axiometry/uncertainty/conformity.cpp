// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/conformity.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/base/decimal_tie.h"

namespace axiometry::uncertainty {
namespace {

using RuleKind = DecisionRule::Kind;

/// Both guard bands.
struct Bands {
  double accept = 0.0;
  double reject = 0.0;
};

/// The largest x in [from, to] for which `holds`, which holds up to some x and not beyond; `from` where it never does.
template <typename Condition>
double last_that_holds(double from, double to, const Condition& holds) {
  constexpr int halvings = 100;  // down to neighbouring numbers
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (from + to);
    (holds(middle) ? from : to) = middle;
  }
  return from;
}

/// Of the magnitude of a signed quantity: the doubt Y − y is moved to where the zones end.
Bands bands_of_magnitude(const Belief& belief, double limit) {
  const double magnitude = std::abs(belief.value());
  const double sign = belief.value() < 0.0 ? -1.0 : 1.0;
  const auto within = [&](double m) { return belief.probability_within(limit, sign * (m - magnitude)); };
  const auto accepted = [&](double m) { return within(m).least >= decision_probability; };
  const auto not_rejected = [&](double m) { return within(m).most > 1.0 - decision_probability; };
  const Range tails{belief.quantile(1.0 - decision_probability).least, belief.quantile(decision_probability).most};
  const double reach = std::max(belief.value() - tails.least, tails.most - belief.value());
  Bands bands;
  bands.accept = accepted(0.0) ? limit - last_that_holds(0.0, limit, accepted) : limit + reach;
  bands.reject = not_rejected(limit) ? last_that_holds(limit, limit + 2.0 * reach, not_rejected) - limit : 0.0;
  return bands;
}

Bands bands_of(const MeasuredValue& measured, double limit, const DecisionRule& rule) {
  if (rule.kind == RuleKind::guard_band) return {rule.guard_band, rule.guard_band};
  if (rule.kind == RuleKind::simple || !measured.belief) return {};
  if (measured.either_sign) return bands_of_magnitude(*measured.belief, limit);
  const double y = measured.belief->value();
  return {std::max(0.0, measured.belief->quantile(decision_probability).most - y),
          std::max(0.0, y - measured.belief->quantile(1.0 - decision_probability).least)};
}

/// A distribution from which known noise has been taken may lie beyond a limit as a whole where the measured value does
/// not. Such a value counts as possible itself.
Range with_the_value(Range conforming, bool value_conforms) {
  if (!value_conforms && conforming.least >= decision_probability) conforming.least = 0.0;
  if (value_conforms && conforming.most <= 1.0 - decision_probability) conforming.most = 1.0;
  return conforming;
}

Verdict by_value(double value, double limit, double guard_band) {
  if (value <= limit - guard_band) return Verdict::conforms;
  return value > limit + guard_band ? Verdict::does_not_conform : Verdict::undecided;
}

Verdict by_probability(const Range& conforming) {
  if (conforming.least >= decision_probability) return Verdict::conforms;
  return conforming.most <= 1.0 - decision_probability ? Verdict::does_not_conform : Verdict::undecided;
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::conforms: return "conforms";
    case Verdict::does_not_conform: return "does not conform";
    case Verdict::undecided: return "undecided";
    case Verdict::not_applicable: break;
  }
  return "not applicable";
}

std::string_view DecisionRule::id() const {
  switch (kind) {
    case RuleKind::simple: return "simple";
    case RuleKind::iso_14253_1: return "iso14253-1";
    case RuleKind::guard_band: break;
  }
  return "guard-band";
}

Decision decide(const MeasuredValue& measured, double limit, const DecisionRule& rule) {
  AXIOMETRY_CONTRACT(rule.guard_band >= 0.0 && measured.rounding >= 0.0);
  const double reached = end_of_tie(limit, measured.rounding);
  const double value = measured.either_sign ? std::abs(measured.value) : measured.value;
  Decision decision;
  const Bands bands = bands_of(measured, limit, rule);
  decision.guard_band = bands.accept;
  decision.rejection_band = bands.reject;
  if (measured.belief)
    decision.probability_range = with_the_value(measured.either_sign ? measured.belief->probability_within(reached)
                                                                     : measured.belief->probability_at_most(reached),
                                                value <= reached);
  if (rule.kind == RuleKind::simple)
    decision.verdict = by_value(value, reached, 0.0);
  else if (!measured.belief)
    decision.verdict = Verdict::undecided;
  else
    decision.verdict = rule.kind == RuleKind::iso_14253_1 ? by_probability(*decision.probability_range)
                                                      : by_value(value, reached, rule.guard_band);
  if (const auto& p = decision.probability_range) {
    decision.probability_conforming = p->cautious();
    if (decision.verdict == Verdict::conforms) decision.consumer_risk = 1.0 - p->least;
    if (decision.verdict == Verdict::does_not_conform) decision.producer_risk = p->most;
  }
  return decision;
}

}  // namespace axiometry::uncertainty
