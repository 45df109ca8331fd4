// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2_monte_carlo.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/standards/iso230_2_trials.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double rounding_noise = 1e-9;  // µm or ″, the error bound of evaluate()

constexpr std::string_view type_a_keys[] = {"pooled", "t-scaled", "resampled"};  // in the order of TypeA

bool acts_as_noise(Effect effect) {
  return effect == Effect::reading || effect == Effect::run || effect == Effect::target ||
         effect == Effect::target_direction;
}

/// What the method cannot treat.
Result<void> check(const Series& series, const UncertaintyInputs& inputs, const MonteCarloOptions& options,
                   Measurand measurand) {
  for (const UncertaintyInput& input : inputs.inputs)
    if (acts_as_noise(input.effect) && !input.distribution.standard_deviation())
      return fail(fmt::format("found the distribution \"{}\" of {}, expected one with a standard deviation",
                              input.distribution.text(), input.key));
  if (measurand == Measurand::this_machine && series.run_count() < 2)
    return fail(
        "found a single approach per direction, expected at least two where the uncertainty of this machine is "
        "wanted: its scatter cannot be known (6.2)");
  (void)options;
  return {};
}

std::size_t index_of(const ParameterInfo* parameter) { return static_cast<std::size_t>(parameter - parameters); }

/// Standard uncertainty of every parameter in a run of its own.
Result<Contribution> contribution(const TrialModel& model, const MonteCarloOptions& options, std::string key,
                                  std::string title) {
  uncertainty::MonteCarloOptions alone = options.propagation;
  alone.trials = std::min(options.contribution_trials, alone.trials.value_or(options.contribution_trials));
  AXIOMETRY_TRY(const auto result, uncertainty::propagate(std::ref(model), model.outputs().size(), alone));
  Contribution found{std::move(key), std::move(title), {}};
  for (std::size_t k = 0; k < model.outputs().size(); ++k) found.u[index_of(model.outputs()[k])] = result.outputs[k].sd;
  return found;
}

Result<std::vector<Contribution>> contributions(const Series& series, const UncertaintyInputs& inputs,
                                                const MonteCarloOptions& options, Measurand measurand) {
  std::vector<Contribution> found;
  if (options.contribution_trials == 0) return found;
  for (std::size_t k = 0; k < inputs.inputs.size(); ++k) {
    const TrialModel model(series, inputs, {Measurand::this_test, options.type_a, options.seed, true, k});
    AXIOMETRY_TRY(Contribution own, contribution(model, options, inputs.inputs[k].key, inputs.inputs[k].title));
    found.push_back(std::move(own));
  }
  if (measurand == Measurand::this_machine) {
    const UncertaintyInputs none;
    const TrialModel model(series, none, {measurand, options.type_a, options.seed, true, std::nullopt});
    AXIOMETRY_TRY(Contribution own, contribution(model, options, "sampling", "Sampling of the approaches"));
    found.push_back(std::move(own));
  }
  return found;
}

/// Noise is treated as normal, whatever its distribution.
std::vector<std::string> notes_on(const UncertaintyInputs& inputs) {
  std::vector<std::string> notes = inputs.notes;
  for (const UncertaintyInput& input : inputs.inputs)
    if (acts_as_noise(input.effect) && !std::holds_alternative<uncertainty::Normal>(input.distribution.form()))
      notes.push_back(fmt::format("{} acts as noise of the readings and is taken as normal with its standard deviation",
                                  input.title));
  return notes;
}

}  // namespace

std::string_view type_a_key(TypeA type_a) { return type_a_keys[static_cast<std::size_t>(type_a)]; }

std::optional<TypeA> find_type_a(std::string_view key) {
  const auto found = std::ranges::find(type_a_keys, key);
  if (found == std::end(type_a_keys)) return std::nullopt;
  return static_cast<TypeA>(found - std::begin(type_a_keys));
}

Result<std::optional<MonteCarlo>> monte_carlo(const Metadata& metadata, const Series& series,
                                              const Evaluation& evaluation, const MonteCarloOptions& options) {
  const Measurand measurand = metadata.gum.measurand.value_or(Measurand::this_test);
  AXIOMETRY_TRY(const UncertaintyInputs inputs, uncertainty_inputs(metadata, series));
  if (inputs.inputs.empty() && measurand == Measurand::this_test) return std::nullopt;
  AXIOMETRY_TRY_VOID(check(series, inputs, options, measurand));
  const TrialModel model(series, inputs, {measurand, options.type_a, options.seed, true, std::nullopt});
  AXIOMETRY_TRY(auto result, uncertainty::propagate(std::ref(model), model.outputs().size(), options.propagation));

  MonteCarlo monte_carlo{
      measurand, options.type_a, options.seed, result.trials,   result.adaptive, true, options.propagation.coverage,
      {},        inputs.inputs,  {},           notes_on(inputs)};
  for (std::size_t k = 0; k < model.outputs().size(); ++k) {
    const ParameterInfo& parameter = *model.outputs()[k];
    if (result.outputs[k].sd < rounding_noise) continue;  // no input acts on it: ±0 would be a false claim
    monte_carlo.stable = monte_carlo.stable && result.outputs[k].stable;
    monte_carlo.distributions[index_of(&parameter)] = {(evaluation.parameters.*parameter.member)->in_native(),
                                                       std::move(result.outputs[k])};
  }
  AXIOMETRY_TRY(monte_carlo.contributions, contributions(series, inputs, options, measurand));
  return monte_carlo;
}

}  // namespace axiometry::iso230_2
