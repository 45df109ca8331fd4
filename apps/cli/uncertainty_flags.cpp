// SPDX-License-Identifier: Apache-2.0
#include "uncertainty_flags.h"

#include <fmt/format.h>

#include <string>

#include "axiometry/app/uncertainty_text.h"
#include "axiometry/base/text.h"

namespace axiometry::cli {
namespace {

constexpr const char* group = "Uncertainty methods";

/// An option whose text `choose` reads into the options, or refuses with a message.
template <typename Choose>
CLI::Option* add_text(CLI::App& verb, const std::string& name, app::UncertaintyOptions& options, Choose choose,
                      const std::string& description) {
  return verb
      .add_option_function<std::string>(
          name,
          [name, &options, choose](const std::string& text) {
            const Result<void> chosen = choose(text, options);
            if (!chosen) throw CLI::ValidationError(name, chosen.error().message);
          },
          description)
      ->group(group);
}

Result<void> choose_type_a(const std::string& text, app::UncertaintyOptions& options) {
  const auto found = iso230_2::find_type_a(text);
  if (!found) return fail(fmt::format("found {}, expected pooled, t-scaled or resampled", text::quoted(text)));
  options.trials.type_a = *found;
  return {};
}

}  // namespace

void add_method_flags(CLI::App& verb, app::UncertaintyOptions& options) {
  add_text(verb, "--uncertainty", options, app::choose_methods,
           "Methods, parted by commas: annex-a (simplified, always there), gum (law of propagation) and monte-carlo "
           "(whole distributions, JCGM 101)")
      ->type_name("METHODS");
  add_text(verb, "--trials", options, app::choose_trials,
           "Monte Carlo trials, or auto: until two digits of every uncertainty are stable (JCGM 101, 7.9)")
      ->type_name("N|auto");
  verb.add_option("--seed", options.trials.seed, "Seed of the random numbers (1): the same seed gives the same result")
      ->type_name("N")
      ->group(group);
  add_text(
      verb, "--type-a", options, choose_type_a,
      "How the sampling of the approaches enters where the measurand is this-machine: pooled, t-scaled or resampled")
      ->type_name("HOW");
  verb.add_option("--coverage", options.trials.propagation.coverage, "Coverage probability of intervals (0.95)")
      ->check(CLI::Range(0.5, 0.9999).description(""))
      ->type_name("P")
      ->group(group);
  verb.add_option("--threads", options.trials.propagation.threads,
                  "Threads (as many as there are); the result does not depend on it")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->group(group);
}

}  // namespace axiometry::cli
