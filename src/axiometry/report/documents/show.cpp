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

int parameter_decimals(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                       const Options& asked) {
  const Options options = fitted(asked, assessment.evaluation.parameters);
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto known = iso230_2::uncertainty_of_record(assessment, parameter);
  // Of an interval a quarter of its width, which of a normal distribution is u.
  const Deviation end = !known     ? Deviation::native(0.0)
                        : known->U ? *known->U
                                   : Deviation::native((known->interval.upper - known->interval.lower) / 4.0);
  return uncertainty_decimals(end, scale, options);
}

ShownParameter show(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                    const Options& asked) {
  const Options options = fitted(asked, assessment.evaluation.parameters);
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto& value = assessment.evaluation.parameters.*parameter.member;
  if (!value) return {"not applicable", "", std::string(scale.unit)};
  const int decimals = parameter_decimals(parameter, assessment, kind, options);
  const auto number = [&](double native) { return format_fixed(native * scale.per_native, decimals, options.numbers); };
  std::string U;
  std::string interval;
  if (const auto known = iso230_2::uncertainty_of_record(assessment, parameter)) {
    if (known->U)
      U = number(known->U->in_native());
    else
      interval = number(known->interval.lower) + " to " + number(known->interval.upper);
  }
  return {number(value->in_native()), U, std::string(scale.unit), interval};
}

}  // namespace axiometry::report
