// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

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

double rounded_to(double x, int places) {
  const double unit = std::pow(10.0, places);
  return std::round(x * unit) / unit;
}

/// As many more as the rounded value needs to lie on the same side of a border as the exact one. `printed` is the
/// border as it stands beside a value of so many places. All are in the unit shown; closer than a rounding of the
/// calculation they are the same.
template <typename Printed>
int decimals_beside(double value, double border, int decimals, const Printed& printed) {
  constexpr int finest = 9;
  if (std::abs(value - border) <= 1e-9 * std::max(1.0, std::abs(border))) return decimals;
  const auto lies_as_exact = [&](int places) {
    const double rounded = rounded_to(value, places);
    return value > border ? rounded > printed(places) : rounded < printed(places);
  };
  while (decimals < finest && !lies_as_exact(decimals)) ++decimals;
  return decimals;
}

/// Beside the limit, which is printed with every digit, and beside T − g and T + g, which have one more than the value.
int decimals_of_decision(const iso230_2::Judgement& judgement, double per_native, int decimals) {
  if (!judgement.magnitude) return decimals;
  const double value = judgement.magnitude->in_native() * per_native;
  const double limit = judgement.tolerance.limit.in_native() * per_native;
  decimals = decimals_beside(value, limit, decimals, [&](int) { return limit; });
  if (judgement.rule.kind == uncertainty::DecisionRule::Kind::simple) return decimals;
  const auto beside = [&](const std::optional<Deviation>& guarded, double (*printed)(double, int)) {
    if (!guarded) return;
    const double border = guarded->in_native() * per_native;
    decimals = decimals_beside(value, border, decimals, [&](int places) { return printed(border, places + 1); });
  };
  beside(judgement.acceptance_limit(), acceptance_limit_to);
  beside(judgement.rejection_limit(), rejection_limit_to);
  return decimals;
}

ShownParameter shown_to(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                        const Options& asked, const iso230_2::Judgement* judgement) {
  const Options options = fitted(asked, assessment.evaluation.parameters);
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto& value = assessment.evaluation.parameters.*parameter.member;
  if (!value) return {"not applicable", "", std::string(scale.unit)};
  int decimals = parameter_decimals(parameter, assessment, kind, options);
  if (judgement != nullptr) decimals = decimals_of_decision(*judgement, scale.per_native, decimals);
  const auto number = [&](double native) { return format_fixed(native * scale.per_native, decimals, options.numbers); };
  std::string U;
  std::string interval;
  if (const auto known = iso230_2::uncertainty_of_record(assessment, parameter)) {
    if (known->U)
      U = number(known->U->in_native());
    else
      interval = number(known->interval.lower) + " to " + number(known->interval.upper);
  }
  return {number(value->in_native()), U, std::string(scale.unit), interval, decimals};
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
