// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/finding_text.h"

#include <algorithm>
#include <cmath>

#include "axiometry/report/shown_number.h"

namespace axiometry::report {
namespace {

constexpr int significant_digits = 3;  // as many as the messages have

std::string with_unit(std::string number, std::string_view unit) {
  return number.append(unit == "°" ? "" : " ").append(unit);
}

/// As deviations stand in messages: without trailing zeros, with a true minus sign, a decimal point.
std::string amount(double value) {
  std::string text = format_fixed(value, std::max(0, decimals_for(std::abs(value), significant_digits)));
  if (text.contains('.')) text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// The parameter whose value this is, to the last bit.
const iso230_2::ParameterInfo* parameter_of(Deviation value, const iso230_2::AxisParameters& measured) {
  for (const auto& parameter : iso230_2::parameters)
    if (const auto& own = measured.*parameter.member; own && own->in_native() == value.in_native()) return &parameter;
  return nullptr;
}

}  // namespace

std::string shown_message(const iso230_2::Finding& finding, const iso230_2::Assessment& assessment, AxisKind kind,
                          const Options& options) {
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const iso230_2::AxisParameters& measured = assessment.evaluation.parameters;
  const auto& all = finding.deviations;
  std::string text;
  std::size_t at = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    // "R would be 3.0 µm instead of 6.6 µm": what a parameter would be stands before what it is.
    const iso230_2::ParameterInfo* parameter = parameter_of(all[k].value, measured);
    const bool before =
        k + 1 < all.size() && finding.message.substr(all[k].at + all[k].length).starts_with(" instead of ");
    if (before) parameter = parameter_of(all[k + 1].value, measured);
    const double value = all[k].value.in_native() * scale.per_native;
    text += finding.message.substr(at, all[k].at - at);
    text += with_unit(
        parameter ? format_fixed(value, parameter_decimals(*parameter, assessment, kind, options)) : amount(value),
        scale.unit);
    at = all[k].at + all[k].length;
  }
  return text + finding.message.substr(at);
}

iso230_2::Finding shown_finding(const iso230_2::Finding& finding, const iso230_2::Assessment& assessment, AxisKind kind,
                                const Options& options) {
  return {finding.id, finding.clause, finding.severity, shown_message(finding, assessment, kind, options)};
}

std::vector<iso230_2::Finding> shown_findings(std::span<const iso230_2::Finding> findings,
                                              const iso230_2::Assessment& assessment, AxisKind kind,
                                              const Options& options) {
  std::vector<iso230_2::Finding> all;
  for (const iso230_2::Finding& finding : findings) all.push_back(shown_finding(finding, assessment, kind, options));
  return all;
}

}  // namespace axiometry::report
