// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/verdict/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"

namespace axiometry::iso230_2 {
namespace {

using uncertainty::Decision;
using uncertainty::DecisionRule;
using uncertainty::Verdict;

constexpr double share_of_limit_negligible = 0.01;

struct Question {
  const ParameterInfo& parameter;
  double value = 0.0;
  double limit = 0.0;
  const DecisionRule& rule;
};

Decision decide_on(const Question& asked, const JudgedWith& with) {
  uncertainty::MeasuredValue measured{.value = asked.value};
  measured.either_sign = is_mean_over_targets(asked.parameter);
  measured.rounding = with.slack.of(asked.parameter, asked.value);
  const auto& known = with.uncertainties[index_of(asked.parameter)];
  if (known && known->doubt.empty()) measured.belief = known->belief;
  return decide(measured, asked.limit, asked.rule);
}

/// Whether a value that is off by the size of an effect, to either side, could be on the other side of where the
/// verdicts change.
bool could_turn(const Decision& decision, const Question& asked, double size) {
  const double magnitude = std::abs(asked.value);
  const auto within_reach = [&](double border) { return std::abs(magnitude - border) <= size; };
  return within_reach(asked.limit - decision.guard_band) || within_reach(asked.limit + decision.rejection_band);
}

/// The largest of the effects on a parameter; one of unknown size is larger than any.
const UncorrectedEffect* largest_effect(const ParameterInfo& parameter, std::span<const UncorrectedEffect> effects) {
  const auto size = [&](const UncorrectedEffect& effect) {
    const auto own = effect.on(parameter);
    return own ? std::abs(own->in_native()) : std::numeric_limits<double>::infinity();
  };
  const auto largest = std::ranges::max_element(effects, {}, size);
  return largest == effects.end() ? nullptr : &*largest;
}

/// The effect that no verdict on this value may leave out of account, if all of them together are not negligible.
const UncorrectedEffect* in_the_way(const Decision& decision, const Question& asked, const JudgedWith& with) {
  double together = 0.0;
  for (const UncorrectedEffect& effect : with.uncorrected) {
    const auto size = effect.on(asked.parameter);
    together += size ? std::abs(size->in_native()) : std::numeric_limits<double>::infinity();
  }
  if (together == 0.0) return nullptr;
  const bool negligible = together <= share_of_limit_negligible * asked.limit && !could_turn(decision, asked, together);
  return negligible ? nullptr : largest_effect(asked.parameter, with.uncorrected);
}

/// Why a value of which terms are missing decides nothing; empty where it does, or none is missing.
std::string missing_terms(const Decision& decision, const ParameterInfo& parameter, const JudgedWith& with) {
  const bool decides = decision.verdict == Verdict::does_not_conform && !is_mean_over_targets(parameter);
  return decides ? "" : with.lower_bounds[index_of(parameter)];
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

std::vector<Tolerance> merged_limits(std::vector<Tolerance> below, std::span<const Tolerance> over) {
  for (const Tolerance& tolerance : over) {
    const auto same = std::ranges::find(below, tolerance.parameter, &Tolerance::parameter);
    if (same == below.end()) {
      below.push_back(tolerance);
      continue;
    }
    Tolerance winner = tolerance;
    winner.replaced = std::move(same->replaced);
    winner.replaced.push_back({same->limit, same->source});
    *same = std::move(winner);
  }
  return below;
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

bool Judgement::has_guard_band() const {
  return withheld.empty() && (rule.kind == DecisionRule::Kind::simple || (magnitude && uncertainty));
}

std::optional<Deviation> Judgement::acceptance_limit() const {
  const double limit = tolerance.limit.in_native() - decision.guard_band;
  if (!has_guard_band() || limit < 0.0) return std::nullopt;
  return Deviation::native(limit);
}

std::optional<Deviation> Judgement::rejection_limit() const {
  if (!has_guard_band()) return std::nullopt;
  return Deviation::native(tolerance.limit.in_native() + decision.rejection_band);
}

std::vector<Judgement> judge(const AxisParameters& measured, std::span<const Tolerance> tolerances,
                             const DecisionRule& rule, const JudgedWith& with) {
  std::vector<Judgement> judgements;
  for (const Tolerance& tolerance : tolerances) {
    AXIOMETRY_CONTRACT(tolerance.parameter != nullptr);
    Judgement judgement{tolerance, rule, {}, {}, {}};
    if (const std::optional<Deviation> value = measured.*(tolerance.parameter->member)) {
      judgement.magnitude = Deviation::native(std::abs(value->in_native()));
      const auto& known = with.uncertainties[index_of(*tolerance.parameter)];
      if (known) judgement.uncertainty = known->stated;
      const Question asked{*tolerance.parameter, value->in_native(), tolerance.limit.in_native(), rule};
      judgement.decision = decide_on(asked, with);
      if (const UncorrectedEffect* effect = in_the_way(judgement.decision, asked, with)) {
        judgement.withheld = effect->reason();
        judgement.remedy = effect->by;
      } else {
        judgement.withheld = missing_terms(judgement.decision, asked.parameter, with);
      }
      if (!judgement.withheld.empty()) {
        judgement.decision = {};
        judgement.decision.verdict = Verdict::undecided;
      } else if (judgement.decision.verdict == Verdict::undecided) {
        judgement.withheld = known ? known->doubt : with.refusals[index_of(*tolerance.parameter)];
      }
    }
    judgements.push_back(std::move(judgement));
  }
  return judgements;
}

std::optional<Verdict> overall_verdict(std::span<const Judgement> judgements) {
  if (judgements.empty()) return std::nullopt;
  const auto verdict_of = [](const Judgement& judgement) { return judgement.decision.verdict; };
  const Verdict worst =
      verdict_of(*std::ranges::max_element(judgements, {}, [&](const Judgement& j) { return gravity(verdict_of(j)); }));
  const bool all_judged = std::ranges::find(judgements, Verdict::not_applicable, verdict_of) == judgements.end();
  return worst == Verdict::conforms && !all_judged ? Verdict::undecided : worst;
}

}  // namespace axiometry::iso230_2
