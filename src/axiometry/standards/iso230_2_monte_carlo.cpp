// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2_monte_carlo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2_trials.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double rounding_noise = 1e-9;  // µm or ″, the error bound of evaluate()

constexpr std::string_view type_a_keys[] = {"pooled", "t-scaled", "resampled"};  // in the order of TypeA

bool acts_as_noise(Effect effect) {
  return effect == Effect::reading || effect == Effect::run || effect == Effect::target ||
         effect == Effect::target_direction;
}

/// What the scatter of the approaches holds.
bool in_scatter(Effect effect) { return effect == Effect::reading || effect == Effect::run; }

/// What the method cannot treat.
Result<void> check(const Series& series, const UncertaintyInputs& inputs, Measurand measurand) {
  for (const UncertaintyInput& input : inputs.inputs)
    if (acts_as_noise(input.effect) && !input.distribution.standard_deviation())
      return fail(fmt::format("found the distribution \"{}\" of {}, expected one with a standard deviation",
                              input.distribution.text(), input.key));
  if (measurand == Measurand::this_machine && series.run_count() < 2)
    return fail(
        "found a single approach per direction, expected at least two where the uncertainty of this machine is "
        "wanted: its scatter cannot be known (6.2)");
  return {};
}

std::size_t index_of(const ParameterInfo* parameter) { return static_cast<std::size_t>(parameter - parameters); }

/// Trials in which a parameter that nothing acts on keeps its measured value to the last digit. Else rounding alone
/// would make it uncertain by some 1e-16, which no adaptive run can settle and no decision may rest on.
class SettledTrials {
 public:
  SettledTrials(TrialModel model, const Evaluation& evaluation) : model_(std::move(model)) {
    for (const ParameterInfo* parameter : model_.outputs())
      measured_.push_back((evaluation.parameters.*parameter->member)->in_native());
  }

  std::span<const ParameterInfo* const> outputs() const { return model_.outputs(); }

  void operator()(std::uint64_t block, uncertainty::BlockOutputs outputs) const {
    model_(block, outputs);
    for (std::size_t k = 0; k < measured_.size(); ++k) {
      const auto row = outputs.row(k);
      const auto settled = [&](double x) { return std::abs(x - measured_[k]) <= rounding_noise; };
      if (std::ranges::all_of(row, settled)) std::ranges::fill(row, measured_[k]);
    }
  }

 private:
  TrialModel model_;
  std::vector<double> measured_;
};

/// Standard uncertainty of every parameter in a run of its own.
Result<Contribution> contribution(const SettledTrials& model, const MonteCarloOptions& options, std::string key,
                                  std::string title) {
  uncertainty::MonteCarloOptions alone = options.propagation;
  alone.trials = std::min(options.contribution_trials, alone.trials.value_or(options.contribution_trials));
  AXIOMETRY_TRY(const auto result, uncertainty::propagate(std::ref(model), model.outputs().size(), alone));
  Contribution found{std::move(key), std::move(title), {}};
  for (std::size_t k = 0; k < model.outputs().size(); ++k) found.u[index_of(model.outputs()[k])] = result.outputs[k].sd;
  return found;
}

Result<std::vector<Contribution>> contributions(const Series& series, const Evaluation& evaluation,
                                                const UncertaintyInputs& inputs, const MonteCarloOptions& options,
                                                Measurand measurand) {
  std::vector<Contribution> found;
  if (options.contribution_trials == 0) return found;
  for (std::size_t k = 0; k < inputs.inputs.size(); ++k) {
    const UncertaintyInput& input = inputs.inputs[k];
    if (measurand == Measurand::this_machine && in_scatter(input.effect)) {
      found.push_back({input.key, input.title, {}});  // in "sampling" already
      continue;
    }
    const SettledTrials model({series, inputs, {Measurand::this_test, options.type_a, options.seed, true, k}},
                              evaluation);
    AXIOMETRY_TRY(Contribution own, contribution(model, options, input.key, input.title));
    found.push_back(std::move(own));
  }
  if (measurand == Measurand::this_machine) {
    const UncertaintyInputs none;
    const SettledTrials model({series, none, {measurand, options.type_a, options.seed, true, std::nullopt}},
                              evaluation);
    AXIOMETRY_TRY(Contribution own, contribution(model, options, "sampling", "Sampling of the approaches"));
    found.push_back(std::move(own));
  }
  return found;
}

/// Noise is treated as normal, whatever its distribution.
std::vector<std::string> notes_on(const UncertaintyInputs& inputs, Measurand measurand) {
  std::vector<std::string> notes = inputs.notes;
  if (measurand == Measurand::this_machine &&
      std::ranges::any_of(inputs.inputs, [](const UncertaintyInput& input) { return in_scatter(input.effect); }))
    notes.emplace_back(scatter_note);
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
  const Measurand measurand = measurand_of(metadata);
  AXIOMETRY_TRY(const UncertaintyInputs inputs, uncertainty_inputs(metadata, series));
  if (inputs.inputs.empty() && measurand == Measurand::this_test) return std::nullopt;
  AXIOMETRY_TRY_VOID(check(series, inputs, measurand));
  const SettledTrials model({series, inputs, {measurand, options.type_a, options.seed, true, std::nullopt}},
                            evaluation);
  AXIOMETRY_TRY(auto result, uncertainty::propagate(std::ref(model), model.outputs().size(), options.propagation));

  MonteCarlo monte_carlo{.measurand = measurand,
                         .type_a = options.type_a,
                         .seed = options.seed,
                         .trials = result.trials,
                         .adaptive = result.adaptive,
                         .stable = true,
                         .coverage = options.propagation.coverage,
                         .distributions = {},
                         .inputs = inputs.inputs,
                         .contributions = {},
                         .notes = notes_on(inputs, measurand)};
  std::vector<std::string_view> constant;
  for (std::size_t k = 0; k < model.outputs().size(); ++k) {
    const ParameterInfo& parameter = *model.outputs()[k];
    if (result.outputs[k].sd < rounding_noise) {
      constant.push_back(parameter.symbol);
      continue;
    }
    monte_carlo.stable = monte_carlo.stable && result.outputs[k].stable;
    monte_carlo.distributions[index_of(&parameter)] = {(evaluation.parameters.*parameter.member)->in_native(),
                                                       std::move(result.outputs[k])};
  }
  if (!constant.empty()) monte_carlo.notes.push_back(no_claim_note(constant));
  AXIOMETRY_TRY(monte_carlo.contributions, contributions(series, evaluation, inputs, options, measurand));
  return monte_carlo;
}

}  // namespace axiometry::iso230_2
