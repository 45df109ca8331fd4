// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/conformity.h"

#include "axiometry/base/contract.h"
#include "axiometry/numeric/special_functions.h"

namespace axiometry::uncertainty {
namespace {

// One-sided 95 % of a normal distribution: 1.645, in practice 1.65.
constexpr double guard_band_factor = 1.65;

std::optional<double> probability_conforming(const MeasuredValue& measured, double limit) {
  if (measured.distribution && measured.distribution->trials() > 0)
    return measured.distribution->probability_below(limit);
  if (!measured.standard_uncertainty) return std::nullopt;
  if (*measured.standard_uncertainty == 0.0) return measured.value <= limit ? 1.0 : 0.0;
  return numeric::normal_probability((limit - measured.value) / *measured.standard_uncertainty);
}

Verdict verdict_of(double value, double limit, double guard_band) {
  if (value <= limit - guard_band) return Verdict::conforms;
  if (value > limit + guard_band) return Verdict::does_not_conform;
  return Verdict::undecided;
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
    case Kind::simple: return "simple";
    case Kind::iso_14253_1: return "iso14253-1";
    case Kind::guard_band: break;
  }
  return "guard-band";
}

Decision decide(const MeasuredValue& measured, double limit, const DecisionRule& rule) {
  AXIOMETRY_CONTRACT(rule.guard_band >= 0.0);
  AXIOMETRY_CONTRACT(!measured.standard_uncertainty || *measured.standard_uncertainty >= 0.0);
  const auto& u = measured.standard_uncertainty;
  Decision decision;
  if (rule.kind == DecisionRule::Kind::iso_14253_1 && u) decision.guard_band = guard_band_factor * *u;
  if (rule.kind == DecisionRule::Kind::guard_band) decision.guard_band = rule.guard_band;
  const bool undecidable = rule.kind != DecisionRule::Kind::simple && !u;
  decision.verdict = undecidable ? Verdict::undecided : verdict_of(measured.value, limit, decision.guard_band);
  decision.probability_conforming = probability_conforming(measured, limit);
  if (const auto& p = decision.probability_conforming) {
    if (decision.verdict == Verdict::conforms) decision.consumer_risk = 1.0 - *p;
    if (decision.verdict == Verdict::does_not_conform) decision.producer_risk = *p;
  }
  return decision;
}

}  // namespace axiometry::uncertainty
