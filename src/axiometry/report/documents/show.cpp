// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

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

namespace {

/// As many more as the rounded value needs to lie on the same side of the limit as the exact one. Both are in the unit
/// shown; closer than a rounding of the calculation they are the same.
int decimals_beside_limit(double value, double limit, int decimals) {
  constexpr int finest = 9;
  if (std::abs(value - limit) <= 1e-9 * std::max(1.0, std::abs(limit))) return decimals;
  const auto lies_as_exact = [&](int places) {
    const double unit = std::pow(10.0, places);
    const double rounded = std::round(value * unit) / unit;
    return value > limit ? rounded > limit : rounded < limit;
  };
  while (decimals < finest && !lies_as_exact(decimals)) ++decimals;
  return decimals;
}

ShownParameter shown_to(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                        const Options& asked, const iso230_2::Judgement* judgement) {
  const Options options = fitted(asked, assessment.evaluation.parameters);
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto& value = assessment.evaluation.parameters.*parameter.member;
  if (!value) return {"not applicable", "", std::string(scale.unit)};
  int decimals = parameter_decimals(parameter, assessment, kind, options);
  if (judgement != nullptr && judgement->magnitude)
    decimals = decimals_beside_limit(judgement->magnitude->in_native() * scale.per_native,
                                     judgement->tolerance.limit.in_native() * scale.per_native, decimals);
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

}  // namespace

ShownParameter show(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                    const Options& options) {
  return shown_to(parameter, assessment, kind, options, nullptr);
}

ShownParameter show(const iso230_2::Judgement& judgement, const iso230_2::Assessment& assessment, AxisKind kind,
                    const Options& options) {
  return shown_to(*judgement.tolerance.parameter, assessment, kind, options, &judgement);
}

}  // namespace axiometry::report
