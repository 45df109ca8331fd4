// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "axiometry/report/report.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

Options fitted(Options options, const iso230_2::AxisParameters& measured) {
  if (options.deviation_decimals) return options;
  constexpr int usual = 1;
  constexpr int significant_digits = 2;
  constexpr int finest = 6;
  options.deviation_decimals = usual;
  for (const auto& size : {measured.A, measured.A_up, measured.A_down, measured.E, measured.E_up, measured.E_down}) {
    if (!size) continue;
    options.deviation_decimals = std::clamp(decimals_for(size->in_native(), significant_digits), usual, finest);
    break;
  }
  return options;
}

UncertaintyShown uncertainty_shown(const iso230_2::Assessment& assessment) {
  if (assessment.annex_a) return UncertaintyShown::annex_a;
  if (assessment.gum) return UncertaintyShown::gum;
  return assessment.monte_carlo ? UncertaintyShown::monte_carlo : UncertaintyShown::none;
}

namespace {

std::optional<Deviation> expanded(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment) {
  if (assessment.annex_a) return assessment.annex_a->U.*parameter.member;
  const auto* found = assessment.gum ? assessment.gum->find(parameter.key) : nullptr;
  return found ? std::optional(found->uncertainty.U) : std::nullopt;
}

const uncertainty::OutputSummary* distribution(const iso230_2::ParameterInfo& parameter,
                                               const iso230_2::Assessment& assessment) {
  if (uncertainty_shown(assessment) != UncertaintyShown::monte_carlo) return nullptr;
  const auto& found =
      assessment.monte_carlo->distributions[static_cast<std::size_t>(&parameter - iso230_2::parameters)];
  return found ? &found->summary : nullptr;
}

}  // namespace

ShownParameter show(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                    const Options& asked) {
  const Options options = fitted(asked, assessment.evaluation.parameters);
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto& value = assessment.evaluation.parameters.*parameter.member;
  if (!value) return {"not applicable", "", std::string(scale.unit)};
  int decimals = std::max(0, *options.deviation_decimals + scale.further_decimals);
  const auto number = [&](double native) { return format_fixed(native * scale.per_native, decimals, options.numbers); };
  const auto end_with = [&](double native) {
    if (native > 0.0) decimals = decimals_for(native * scale.per_native, options.uncertainty_digits);
  };
  std::string U;
  std::string interval;
  if (const auto known = expanded(parameter, assessment)) {
    end_with(known->in_native());
    U = number(known->in_native());
  } else if (const auto* known_distribution = distribution(parameter, assessment)) {
    end_with(known_distribution->sd);
    const auto& [lower, upper] = known_distribution->symmetric;
    interval = number(lower) + " to " + number(upper);
  }
  return {number(value->in_native()), U, std::string(scale.unit), interval};
}

}  // namespace axiometry::report
