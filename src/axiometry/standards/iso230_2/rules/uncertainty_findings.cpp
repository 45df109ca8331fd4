// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/uncertainty_findings.h"

#include <cmath>
#include <optional>

#include "axiometry/base/rounded_text.h"
#include "axiometry/standards/iso230_2/monte_carlo/noise.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"

namespace axiometry::iso230_2 {
namespace {

std::optional<Finding> variation_against_readings(const Test& test) {
  const auto& variation = test.metadata.uncertainty.environmental_variation;
  if (!variation || !test.metadata.gum.drift_recording.empty()) return std::nullopt;
  const double white = variation->in_native() / std::sqrt(12.0);  // (A.9) of a uniform distribution
  const WithinRuns within = within_runs(test.series, course_of(test));
  const double p = within.probability_of(white);
  if (p >= refuted_below) return std::nullopt;
  const AxisKind kind = test.metadata.axis.kind;
  const rules::Message found = rules::message(
      "E_VE = {} as noise from reading to reading would scatter them by {} within runs, where they scatter by {} "
      "({})",
      rules::deviation_message(kind, variation->in_native()), rules::deviation_message(kind, white),
      rules::deviation_message(kind, within.sd()), format_chance(p));
  if (test.metadata.gum.environment_kind == EnvironmentKind::white)
    return rules::missing("variation-against-readings", "A.2.5",
                          rules::message("{}: it cannot be the white noise that it is stated to be, and counts as "
                                         "a slow drift or a random walk",
                                         found));
  return rules::note("variation-against-readings", "A.2.5",
                     rules::message("{}: it is a slow variation, or much overstated", found));
}

std::optional<Finding> no_interval(const Assessment& assessment) {
  if (!assessment.monte_carlo) return std::nullopt;
  for (const auto& found : assessment.monte_carlo->distributions)
    if (found && !found->refusal.empty())
      return rules::missing("no-interval", "8.2.1", std::string(refusal_sentence) + found->refusal);
  return std::nullopt;
}

std::optional<Finding> measurand_not_reached(const Test& test, const Assessment& assessment) {
  if (test.metadata.gum.measurand != Measurand::this_machine ||
      method_of_record(assessment) != UncertaintyMethod::annex_a)
    return std::nullopt;
  return rules::missing(
      "measurand-not-reached", "8.2.1",
      "uncertainty.measurand = this-machine does not reach Annex A, whose U is that of the value of this "
      "test; GUM and Monte Carlo know it");
}

}  // namespace

std::vector<Finding> uncertainty_findings(const Test& test, const Assessment& assessment) {
  std::vector<Finding> findings;
  for (auto& finding :
       {variation_against_readings(test), no_interval(assessment), measurand_not_reached(test, assessment)})
    if (finding) findings.push_back(*finding);
  return findings;
}

}  // namespace axiometry::iso230_2
