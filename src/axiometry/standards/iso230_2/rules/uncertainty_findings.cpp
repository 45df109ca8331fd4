// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/uncertainty_findings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/standards/iso230_2/inputs/inputs.h"
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
    return rules::answered_by(
        {"uncertainty.environment_kind"},
        rules::missing("variation-against-readings", "A.2.5",
                       rules::message("{}: it cannot be the white noise that it is stated to be, and counts as "
                                      "a slow drift or a random walk",
                                      found)));
  return rules::note("variation-against-readings", "A.2.5",
                     rules::message("{}: it is a slow variation, or much overstated", found));
}

/// What is known to scatter the readings of a cell, standard deviation; E_VE as noise, unless it is stated to be slow.
struct KnownNoise {
  double of_environment = 0.0, others = 0.0;
};

KnownNoise known_noise(const Test& test) {
  const auto kind = test.metadata.gum.environment_kind.value_or(EnvironmentKind::unknown);
  const bool slow = kind == EnvironmentKind::drift || kind == EnvironmentKind::random_walk;
  KnownNoise noise;
  const auto inputs = uncertainty_inputs(test.metadata, test.series, test.provenance.stated);
  if (!inputs) return noise;
  for (const UncertaintyInput& input : inputs->inputs) {
    const double u = input.distribution.standard_deviation().value_or(0.0);
    if (input.key == "environmental_variation")
      noise.of_environment = slow ? 0.0 : u;
    else if (input.effect == Effect::reading || input.effect == Effect::run)
      noise.others = std::hypot(noise.others, u);
  }
  return noise;
}

/// Noise of a reading adds to s², and so is no small change of s where it is not small against it: A and R are shown
/// larger than they are, mostly, and value ± U of a method of first order lies above what it should hold. Of this
/// machine Annex A says nothing, which another finding tells; nor is E_VE noise where the readings refute it.
std::optional<Finding> noise_beside_scatter(const Test& test, const Assessment& assessment, bool environment_refuted) {
  constexpr double small = 0.5;  // of the largest s; up to here simulated tests held A and R in 94 % and more
  const auto method = method_of_record(assessment);
  const bool of_machine = test.metadata.gum.measurand == Measurand::this_machine;
  if (method != UncertaintyMethod::gum && (method != UncertaintyMethod::annex_a || of_machine)) return std::nullopt;
  double largest = 0.0;
  for (const PositionResult& p : assessment.evaluation.positions)
    for (const auto& s : {p.s_up, p.s_down}) largest = std::max(largest, s ? s->in_native() : 0.0);
  KnownNoise known = known_noise(test);
  if (environment_refuted) known.of_environment = 0.0;
  const double noise = std::hypot(known.of_environment, known.others);
  if (largest == 0.0 || noise <= small * largest) return std::nullopt;
  const AxisKind kind = test.metadata.axis.kind;
  const auto& variation = test.metadata.uncertainty.environmental_variation;
  const rules::Message size = rules::deviation_message(kind, noise), scatter = rules::deviation_message(kind, largest);
  const rules::Message found =
      known.others == 0.0 && variation
          ? rules::message("E_VE = {} as noise from reading to reading is {} beside a scatter of {} at most",
                           rules::deviation_message(kind, variation->in_native()), size, scatter)
          : rules::message("The known noise of readings and runs is {} beside a scatter of {} at most", size, scatter);
  return rules::note("noise-beside-scatter", "8.2.1",
                     rules::message("{}: such noise makes A and R larger, mostly, and by more than Annex A and GUM "
                                    "see, so that they may be smaller than the value less U, and a limit that seems "
                                    "exceeded may be kept; Monte Carlo sees it",
                                    found));
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
  return rules::answered_by(
      {"uncertainty.measurand", "uncertainty.method"},
      rules::missing(
          "measurand-not-reached", "8.2.1",
          "uncertainty.measurand = this-machine does not reach Annex A, whose U is that of the value of this "
          "test; GUM and Monte Carlo know it"));
}

}  // namespace

std::vector<Finding> uncertainty_findings(const Test& test, const Assessment& assessment) {
  std::vector<Finding> findings;
  const auto variation = variation_against_readings(test);
  for (auto& finding : {variation, noise_beside_scatter(test, assessment, variation.has_value()),
                        no_interval(assessment), measurand_not_reached(test, assessment)})
    if (finding) findings.push_back(*finding);
  return findings;
}

}  // namespace axiometry::iso230_2
