// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/uncertainty_flags.h"

#include <string>

#include "axiometry/app/evaluate/uncertainty_text.h"

namespace axiometry::cli {
namespace {

constexpr const char* group = "Uncertainty methods";

/// An option whose text `choose` reads into the options, or refuses with a message.
template <typename Choose>
Flag add_text(const Verb& verb, const std::string& name, app::UncertaintyOptions& options, Choose choose,
              const std::string& description) {
  return verb
      .add_option_function<std::string>(
          name,
          [name, &options, choose](const std::string& text) {
            const Result<void> chosen = choose(text, options);
            if (!chosen) throw UsageError(name, chosen.error().message);
          },
          description)
      ->group(group);
}

}  // namespace

void add_kept_method_flags(const Verb& verb, app::UncertaintyOptions& options) {
  add_text(verb, "--uncertainty", options, app::choose_methods,
           "Methods, separated by commas: annex-a (simplified, always there), gum (law of propagation) and monte-carlo "
           "(whole distributions, JCGM 101)")
      ->type_name("METHODS");
  add_text(verb, "--trials", options, app::choose_trials,
           "Monte Carlo trials, or auto: until two digits of every uncertainty are stable (JCGM 101, 7.9)")
      ->type_name("N|auto");
  add_text(verb, "--seed", options, app::choose_seed,
           "Seed of the random numbers (1): the same seed gives the same result")
      ->type_name("N");
  add_text(
      verb, "--type-a", options, app::choose_type_a,
      "How the sampling of the approaches enters where the measurand is this-machine: pooled, t-scaled or resampled")
      ->type_name("HOW");
  add_text(verb, "--coverage", options, app::choose_coverage, "Coverage probability of intervals (0.95)")
      ->type_name("P");
}

void add_method_flags(const Verb& verb, app::UncertaintyOptions& options) {
  add_kept_method_flags(verb, options);
  verb.add_option("--threads", options.trials.propagation.threads,
                  "Threads (as many as there are); the result does not depend on it")
      ->check_range(1, 1024)
      ->type_name("N")
      ->group(group);
}

void check_method_flags(const Verb& verb, const app::UncertaintyOptions& options, bool other_work_has_threads) {
  const std::optional<Flag> record = verb.find_option("--method");
  const bool of_record = record && (*record)->count() > 0 && (*record)->results().back() == "monte-carlo";
  if (options.monte_carlo || of_record) return;
  for (const char* flag : {"--trials", "--seed", "--type-a", "--coverage", "--threads"}) {
    if (other_work_has_threads && std::string_view(flag) == "--threads") continue;
    if (const auto given = verb.find_option(flag); given && given->count() > 0)
      throw UsageError(flag, "found it without the method it belongs to, expected --uncertainty monte-carlo");
  }
}

}  // namespace axiometry::cli
