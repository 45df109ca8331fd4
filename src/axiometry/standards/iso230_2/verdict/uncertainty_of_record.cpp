// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/contract.h"
#include "axiometry/standards/iso230_2/monte_carlo/type_a_doubt.h"

namespace axiometry::iso230_2 {
namespace {

using uncertainty::Belief;
using uncertainty::Interval;

constexpr double coverage_factor_stated = 2.0;  // U = 2 u (A.2.1)

ParameterUncertainty expanded(UncertaintyMethod method, std::optional<Measurand> measurand, double value, double U) {
  const double u = U / coverage_factor_stated;
  return {{method, measurand, Deviation::native(u), Deviation::native(U), {value - U, value + U}},
          Belief::normal(value, u)};
}

std::optional<ParameterUncertainty> of_annex_a(const AnnexA& annex_a, const ParameterInfo& parameter, double value) {
  const auto& U = annex_a.U.*parameter.member;
  if (!U) return std::nullopt;
  return expanded(UncertaintyMethod::annex_a, std::nullopt, value, U->in_native());
}

std::optional<ParameterUncertainty> of_gum(const GumUncertainty& gum, const ParameterInfo& parameter, double value) {
  const GumParameter* found = gum.find(parameter.key);
  if (found == nullptr) return std::nullopt;
  const ExpandedUncertainty& own = found->uncertainty;
  auto known = expanded(UncertaintyMethod::gum, gum.measurand, value, own.U.in_native());
  // Of a result that was kept only U is at hand.
  if (!own.effective_degrees_of_freedom || !(own.u.in_native() > 0.0)) return known;
  known.stated.u = own.u;
  known.stated.degrees_of_freedom = own.effective_degrees_of_freedom;
  known.belief = Belief::student_t(value, own.u.in_native(), *own.effective_degrees_of_freedom);
  return known;
}

/// A mean over the targets does not grow with noise, as extremes do.
std::string doubt_of(const MonteCarlo& run, const ParameterInfo& parameter) {
  if (run.type_a == TypeA::t_scaled && parameter.member == &AxisParameters::B_mean) return "";
  return doubt_of_type_a(run.measurand, run.type_a);
}

std::optional<ParameterUncertainty> of_monte_carlo(const MonteCarlo& run, const ParameterInfo& parameter,
                                                   double value) {
  const auto& found = run.distributions[index_of(parameter)];
  if (!found || !found->refusal.empty()) return std::nullopt;
  const uncertainty::OutputSummary& summary = found->summary;
  const Interval interval{std::min(value, found->low), std::max(value, found->high)};
  auto distributions = held_possible(run, parameter);
  return ParameterUncertainty{
      {UncertaintyMethod::monte_carlo, run.measurand, Deviation::native(summary.sd), std::nullopt, interval},
      distributions.empty() ? Belief::normal(value, summary.sd) : Belief::sampled(value, std::move(distributions)),
      doubt_of(run, parameter)};
}

/// As the method has it, be it 0.
std::optional<ParameterUncertainty> found_by_method(const Assessment& assessment, const ParameterInfo& parameter) {
  const auto& value = assessment.evaluation.parameters.*parameter.member;
  const auto method = method_of_record(assessment);
  if (!value || !method) return std::nullopt;
  const double native = value->in_native();
  switch (*method) {
    case UncertaintyMethod::annex_a:
      return assessment.annex_a ? of_annex_a(*assessment.annex_a, parameter, native) : std::nullopt;
    case UncertaintyMethod::gum: return assessment.gum ? of_gum(*assessment.gum, parameter, native) : std::nullopt;
    case UncertaintyMethod::monte_carlo:
      return assessment.monte_carlo ? of_monte_carlo(*assessment.monte_carlo, parameter, native) : std::nullopt;
  }
  return std::nullopt;
}

/// Nothing is known without doubt: an uncertainty of 0 is none, and decides nothing.
std::optional<ParameterUncertainty> parameter_uncertainty(const Assessment& assessment,
                                                          const ParameterInfo& parameter) {
  auto found = found_by_method(assessment, parameter);
  if (found && !(found->stated.u.in_native() > 0.0)) found.reset();
  return found;
}

std::string refusal_of_record(const Assessment& assessment, const ParameterInfo& parameter) {
  const auto method = method_of_record(assessment);
  if (!method || !(assessment.evaluation.parameters.*parameter.member) || parameter_uncertainty(assessment, parameter))
    return "";
  if (*method == UncertaintyMethod::monte_carlo && assessment.monte_carlo) {
    const auto& found = assessment.monte_carlo->distributions[index_of(parameter)];
    if (found && !found->refusal.empty()) return fmt::format("no interval is stated: {}", found->refusal);
  }
  if (found_by_method(assessment, parameter))
    return fmt::format("the method of record, {}, finds an uncertainty of 0 of {}, which is none",
                       method_title(*method), parameter.symbol);
  return fmt::format("the method of record, {}, states no uncertainty of {}", method_title(*method), parameter.symbol);
}

}  // namespace

std::string_view method_key(UncertaintyMethod method) {
  switch (method) {
    case UncertaintyMethod::annex_a: return "annex_a";
    case UncertaintyMethod::gum: return "gum";
    case UncertaintyMethod::monte_carlo: return "monte_carlo";
  }
  return "";
}

std::string_view method_word(UncertaintyMethod method) {
  switch (method) {
    case UncertaintyMethod::annex_a: return "annex-a";
    case UncertaintyMethod::gum: return "gum";
    case UncertaintyMethod::monte_carlo: return "monte-carlo";
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

std::size_t index_of(const ParameterInfo& parameter) {
  const auto* found = std::ranges::find(parameters, parameter.member, &ParameterInfo::member);
  AXIOMETRY_CONTRACT(found != std::end(parameters));
  return static_cast<std::size_t>(found - std::begin(parameters));
}

std::optional<UncertaintyMethod> method_of_record(const Assessment& assessment) {
  if (assessment.method_of_record) return assessment.method_of_record;
  if (assessment.monte_carlo) return UncertaintyMethod::monte_carlo;
  if (assessment.annex_a) return UncertaintyMethod::annex_a;
  return assessment.gum ? std::optional(UncertaintyMethod::gum) : std::nullopt;
}

const MonteCarlo* run_with_intervals(const Assessment& assessment) {
  if (!assessment.monte_carlo) return nullptr;
  const auto states = [](const auto& found) { return found && found->refusal.empty(); };
  return std::ranges::any_of(assessment.monte_carlo->distributions, states) ? &*assessment.monte_carlo : nullptr;
}

std::vector<uncertainty::Possible> held_possible(const MonteCarlo& run, const ParameterInfo& parameter) {
  std::vector<uncertainty::Possible> all;
  const auto& found = run.distributions[index_of(parameter)];
  if (!found || !found->refusal.empty()) return all;
  for (std::size_t h = 0; h < found->by_hypothesis.size(); ++h) {
    const uncertainty::SampledDistribution& trials = found->by_hypothesis[h].distribution;
    if (trials.trials() == 0) continue;
    all.push_back({&trials, 0.0});
    if (const double shift = found->shift_of(h); shift != 0.0) all.push_back({&trials, shift});
  }
  return all;
}

std::optional<StatedUncertainty> uncertainty_of_record(const Assessment& assessment, const ParameterInfo& parameter) {
  const auto found = parameter_uncertainty(assessment, parameter);
  return found ? std::optional(found->stated) : std::nullopt;
}

ParameterUncertainties uncertainties_of_record(const Assessment& assessment) {
  ParameterUncertainties all;
  for (std::size_t k = 0; k < std::size(parameters); ++k) all[k] = parameter_uncertainty(assessment, parameters[k]);
  return all;
}

UncertaintyRefusals refusals_of_record(const Assessment& assessment) {
  UncertaintyRefusals all;
  for (std::size_t k = 0; k < std::size(parameters); ++k) all[k] = refusal_of_record(assessment, parameters[k]);
  return all;
}

}  // namespace axiometry::iso230_2
