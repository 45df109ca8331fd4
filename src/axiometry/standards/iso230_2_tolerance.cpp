// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2_tolerance.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/special_functions.h"

namespace axiometry::iso230_2 {
namespace {

using uncertainty::Decision;
using uncertainty::DecisionRule;
using uncertainty::Verdict;

constexpr double annex_a_coverage_factor = 2.0;  // U = 2 u (A.2.1)

/// P(−limit ≤ B̄ ≤ limit): the one signed parameter can leave its tolerance on either side.
double probability_within(double value, const ParameterUncertainty& known, double limit) {
  const double u = known.standard.u.in_native();
  if (const auto* distribution = known.distribution)
    return std::max(0.0, distribution->probability_below(limit) - distribution->probability_below(-limit));
  if (u == 0.0) return std::abs(value) <= limit ? 1.0 : 0.0;
  return numeric::normal_probability((limit - value) / u) - numeric::normal_probability((-limit - value) / u);
}

/// The decision with another probability of conformity, on which its risks rest.
Decision with_probability(Decision decision, double probability) {
  decision.probability_conforming = probability;
  if (decision.consumer_risk) decision.consumer_risk = 1.0 - probability;
  if (decision.producer_risk) decision.producer_risk = probability;
  return decision;
}

Decision decide_on(const ParameterInfo& parameter, double value, const std::optional<ParameterUncertainty>& known,
                   double limit, const DecisionRule& rule) {
  uncertainty::MeasuredValue measured{.value = std::abs(value)};
  if (!known) return decide(measured, limit, rule);
  measured.standard_uncertainty = known->standard.u.in_native();
  const bool is_signed = parameter.member == &AxisParameters::B_mean;
  if (is_signed) return with_probability(decide(measured, limit, rule), probability_within(value, *known, limit));
  if (known->distribution != nullptr) measured.distribution = *known->distribution;
  return decide(measured, limit, rule);
}

std::size_t index_of(const ParameterInfo& parameter) {
  const auto* found = std::ranges::find(parameters, parameter.member, &ParameterInfo::member);
  AXIOMETRY_CONTRACT(found != std::end(parameters));
  return static_cast<std::size_t>(found - std::begin(parameters));
}

/// Rank of a verdict among several: the largest decides.
int gravity(Verdict verdict) {
  switch (verdict) {
    case Verdict::not_applicable: return 0;
    case Verdict::conforms: return 1;
    case Verdict::undecided: return 2;
    case Verdict::does_not_conform: return 3;
  }
  return 0;
}

}  // namespace

std::string_view tolerance_source_key(ToleranceSource source) {
  switch (source) {
    case ToleranceSource::axis: return "axis";
    case ToleranceSource::table: return "table";
    case ToleranceSource::test: return "test";
    case ToleranceSource::entered: return "entered";
    case ToleranceSource::user: return "user";
  }
  return "";
}

std::string_view method_key(UncertaintyMethod method) {
  switch (method) {
    case UncertaintyMethod::annex_a: return "annex_a";
    case UncertaintyMethod::gum: return "gum";
    case UncertaintyMethod::monte_carlo: return "monte_carlo";
  }
  return "";
}

std::string_view method_title(UncertaintyMethod method) {
  switch (method) {
    case UncertaintyMethod::annex_a: return "Annex A";
    case UncertaintyMethod::gum: return "GUM";
    case UncertaintyMethod::monte_carlo: return "Monte Carlo";
  }
  return "";
}

std::vector<Tolerance> stated_tolerances(const Metadata& metadata) {
  using Stated = StatedTolerances;
  // In the order of `parameters`.
  static constexpr std::optional<Deviation> Stated::*members[] = {
      &Stated::A, &Stated::A_up, &Stated::A_down, &Stated::E,      &Stated::E_up, &Stated::E_down,
      &Stated::M, &Stated::R,    &Stated::R_up,   &Stated::R_down, &Stated::B,    &Stated::B_mean};
  static_assert(std::size(members) == std::size(parameters));
  std::vector<Tolerance> tolerances;
  for (std::size_t k = 0; k < std::size(parameters); ++k)
    if (const auto& limit = metadata.tolerance.*members[k])
      tolerances.push_back({&parameters[k], *limit, ToleranceSource::test});
  return tolerances;
}

ParameterUncertainties deciding_uncertainties(const Assessment& assessment) {
  ParameterUncertainties all;
  for (std::size_t k = 0; k < std::size(parameters); ++k) {
    const ParameterInfo& parameter = parameters[k];
    if (assessment.monte_carlo && assessment.monte_carlo->distributions[k]) {
      const uncertainty::OutputSummary& summary = assessment.monte_carlo->distributions[k]->summary;
      const bool drawn = summary.distribution.trials() > 0;
      all[k] = {{Deviation::native(summary.sd), UncertaintyMethod::monte_carlo, assessment.monte_carlo->measurand},
                drawn ? &summary.distribution : nullptr};
    } else if (const GumParameter* gum = assessment.gum ? assessment.gum->find(parameter.key) : nullptr) {
      all[k] = {{gum->uncertainty.u, UncertaintyMethod::gum, assessment.gum->measurand}};
    } else if (assessment.annex_a && assessment.annex_a->U.*parameter.member) {
      const Deviation U = *(assessment.annex_a->U.*parameter.member);
      all[k] = {{Deviation::native(U.in_native() / annex_a_coverage_factor), UncertaintyMethod::annex_a}};
    }
  }
  return all;
}

bool Judgement::has_guard_band() const { return rule.kind == DecisionRule::Kind::simple || (magnitude && uncertainty); }

std::optional<Deviation> Judgement::acceptance_limit() const {
  const double limit = tolerance.limit.in_native() - decision.guard_band;
  if (!has_guard_band() || limit < 0.0) return std::nullopt;
  return Deviation::native(limit);
}

std::optional<Deviation> Judgement::rejection_limit() const {
  if (!has_guard_band()) return std::nullopt;
  return Deviation::native(tolerance.limit.in_native() + decision.guard_band);
}

std::vector<Judgement> judge(const AxisParameters& measured, std::span<const Tolerance> tolerances,
                             const DecisionRule& rule, const ParameterUncertainties& uncertainties) {
  std::vector<Judgement> judgements;
  for (const Tolerance& tolerance : tolerances) {
    AXIOMETRY_CONTRACT(tolerance.parameter != nullptr);
    Judgement judgement{tolerance, rule, {}, {}, {}};
    if (const std::optional<Deviation> value = measured.*(tolerance.parameter->member)) {
      judgement.magnitude = Deviation::native(std::abs(value->in_native()));
      const auto& known = uncertainties[index_of(*tolerance.parameter)];
      if (known) judgement.uncertainty = known->standard;
      judgement.decision =
          decide_on(*tolerance.parameter, value->in_native(), known, tolerance.limit.in_native(), rule);
    }
    judgements.push_back(std::move(judgement));
  }
  return judgements;
}

std::optional<Verdict> overall_verdict(std::span<const Judgement> judgements) {
  if (judgements.empty()) return std::nullopt;
  return std::ranges::max(judgements, {}, [](const Judgement& j) { return gravity(j.decision.verdict); })
      .decision.verdict;
}

}  // namespace axiometry::iso230_2
