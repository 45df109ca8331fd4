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

ShownParameter show(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                    const Options& asked) {
  const Options options = fitted(asked, assessment.evaluation.parameters);
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto& value = assessment.evaluation.parameters.*parameter.member;
  if (!value) return {"not applicable", "", std::string(scale.unit)};
  int decimals = std::max(0, *options.deviation_decimals + scale.further_decimals);
  std::string U;
  if (assessment.annex_a && assessment.annex_a->U.*parameter.member) {
    const double uncertainty = (assessment.annex_a->U.*parameter.member)->in_native() * scale.per_native;
    if (uncertainty > 0.0) decimals = decimals_for(uncertainty, options.uncertainty_digits);
    U = format_fixed(uncertainty, decimals, options.numbers);
  }
  return {format_fixed(value->in_native() * scale.per_native, decimals, options.numbers), U, std::string(scale.unit)};
}

}  // namespace axiometry::report
