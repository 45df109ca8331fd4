// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/assumptions.h"

#include <fmt/format.h>

#include "axiometry/report/method_values.h"
#include "axiometry/standards/iso230_2/monte_carlo/noise.h"

namespace axiometry::report {
namespace {

using iso230_2::Measurand;
using iso230_2::UncertaintyMethod;

/// "… at 20 °C" would be false of readings that hold what could be corrected.
std::string_view but_for_what_is_known(const iso230_2::Assessment& assessment) {
  return assessment.uncorrected.empty() ? "" : ", but for what the findings tell as not corrected";
}

std::string measurand_words(Measurand measurand, const iso230_2::Assessment& assessment) {
  if (measurand == Measurand::this_machine) return "the parameter that the axis has in the long run";
  return fmt::format("the parameter that the same approaches would have given with perfect instruments at 20 °C{}",
                     but_for_what_is_known(assessment));
}

/// What E_VE was taken for.
std::string_view environment_words(const Test& test) {
  const Metadata& metadata = test.metadata;
  if (!metadata.uncertainty.environmental_variation) return "No environmental variation was stated, and none counts";
  if (!metadata.gum.drift_recording.empty())
    return "The environmental variation counts as it was recorded at standstill";
  switch (metadata.gum.environment_kind.value_or(EnvironmentKind::unknown)) {
    case EnvironmentKind::unknown:
      return "The kind of the environmental variation is not known: none, noise from reading to reading, slow drift "
             "and "
             "a random walk are held possible as far as the readings do not refute them";
    case EnvironmentKind::white: break;
    case EnvironmentKind::drift: return "The environmental variation counts as a slow drift";
    case EnvironmentKind::random_walk: return "The environmental variation counts as a random walk";
  }
  return iso230_2::refutes_stated_white(test)
             ? "The environmental variation was stated as independent from reading to reading, which the readings "
               "refute: none, a slow drift and a random walk are held possible in its place"
             : "The environmental variation counts as independent from reading to reading";
}

bool has_noise(const iso230_2::MonteCarlo& run) { return run.hypotheses.size() > 1; }

/// Runs that were drawn again, or cells taken for themselves: nothing Bayesian about either. What they held is measured
/// in docs/studies/coverage.md.
std::vector<std::string> of_sampling(const iso230_2::MonteCarlo& run, const Subject& subject, const Options& options) {
  const bool bootstrap = run.type_a == iso230_2::TypeA::resampled;
  return {
      fmt::format("The interval is {}, made to hold {} in {} of tests: in simulated tests it held A, B, R, R↑ and R↓ "
                  "less often, R↑ and R↓ in fewer than half of them.",
                  bootstrap ? "a bootstrap one, of runs drawn again from those that were measured"
                            : "one of Student’s t and χ² for every target and direction by itself (JCGM 101, 6.4.9.2)",
                  measurand_words(run.measurand, subject.assessment), shown_percent(run.coverage, options)),
      "Noise of the instrument and of the environment is part of the scatter.",
      "The parameters are extremes, of which neither way sees that few approaches make them larger on average."};
}

std::vector<std::string> of_monte_carlo(const iso230_2::MonteCarlo& run, const Subject& subject,
                                        const Options& options) {
  if (iso230_2::run_with_intervals(subject.assessment) == nullptr) return {refusal_statement(run) + "."};
  if (run.measurand == Measurand::this_machine && run.type_a != iso230_2::TypeA::pooled)
    return of_sampling(run, subject, options);
  const std::string measurand = measurand_words(run.measurand, subject.assessment);
  const std::string coverage = shown_percent(run.coverage, options);
  std::vector<std::string> sentences;
  if (has_noise(run))
    sentences.push_back(
        fmt::format("The interval is a Bayesian one: given the readings and what is known of the inputs, {} lies in it "
                    "with a probability of {} or more, whichever kind of noise that is held possible there was.",
                    measurand, coverage));
  else
    sentences.push_back(
        fmt::format("The interval is a Bayesian one: given the readings and what is known of the inputs, {} lies in it "
                    "with a probability of {}.",
                    measurand, coverage));
  const std::string environment(environment_words(subject.test));
  sentences.push_back(has_noise(run) || run.measurand == Measurand::this_machine
                          ? environment +
                                "; before the readings every size of the machine’s own scatter was equally likely in "
                                "every octave."
                          : environment + ".");
  sentences.emplace_back(
      has_noise(run)
          ? "Noise makes the parameters, which are extremes, larger on average: the measured value is not corrected "
            "for "
            "that and stands in its interval, which reaches below it as far as the readings may hold such noise."
          : "Noise makes the parameters, which are extremes, larger on average: none was stated, and the interval "
            "knows "
            "nothing of it.");
  return sentences;
}

std::vector<std::string> of_gum(const iso230_2::GumUncertainty& gum, const Subject& subject) {
  return {
      fmt::format(
          "U is for about 95 %, by the law of propagation, as far as that is linear and its bias is not counted: "
          "how far {} may be from the measured value.",
          measurand_words(gum.measurand, subject.assessment)),
      fmt::format("{}; all inputs count to first order.", environment_words(subject.test)),
      "That noise makes the parameters, which are extremes, larger on average is neither corrected nor part of U; the "
      "Monte Carlo method tells of it."};
}

/// The annex knows one kind of environmental variation.
std::string annex_a_environment(const Metadata& metadata) {
  if (!metadata.uncertainty.environmental_variation) return "No environmental variation was stated, and none counts.";
  const auto kind = metadata.gum.environment_kind.value_or(EnvironmentKind::unknown);
  if (kind == EnvironmentKind::drift || kind == EnvironmentKind::random_walk)
    return "The environmental variation counts as one slow swing over the test where the annex takes repeatability "
           "from "
           "noise of single readings.";
  const bool stated_so = kind == EnvironmentKind::white;
  return fmt::format("The factors of the annex take the environmental variation for noise from reading to reading{}.",
                     stated_so ? "" : ", which nobody has said it is");
}

std::vector<std::string> of_annex_a(const Subject& subject) {
  return {
      fmt::format("U (k = 2) is that of Annex A: the contributors that were given, independent of each other, for the "
                  "value of this test at 20 °C{}.",
                  but_for_what_is_known(subject.assessment)),
      annex_a_environment(subject.test.metadata),
      "That noise makes the parameters, which are extremes, larger on average is neither corrected nor part of U."};
}

}  // namespace

std::vector<std::string> interval_assumptions(const Subject& subject, const Options& options) {
  const iso230_2::Assessment& assessment = subject.assessment;
  const auto method = iso230_2::method_of_record(assessment);
  if (method == UncertaintyMethod::annex_a && assessment.annex_a) return of_annex_a(subject);
  if (method == UncertaintyMethod::gum && assessment.gum) return of_gum(*assessment.gum, subject);
  if (method == UncertaintyMethod::monte_carlo && assessment.monte_carlo)
    return of_monte_carlo(*assessment.monte_carlo, subject, options);
  return {};
}

}  // namespace axiometry::report
