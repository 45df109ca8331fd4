// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/standards/iso230_2/monte_carlo/gross_errors.h"
#include "axiometry/standards/iso230_2/monte_carlo/mean_distributions.h"
#include "axiometry/standards/iso230_2/monte_carlo/settled_trials.h"
#include "axiometry/standards/iso230_2/monte_carlo/trial_figures.h"
#include "axiometry/standards/iso230_2/monte_carlo/trials.h"
#include "axiometry/standards/iso230_2/monte_carlo/type_a_doubt.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"
#include "axiometry/standards/readings/test_course.h"

namespace axiometry::iso230_2 {
namespace {

constexpr std::size_t most_means = 120;          // targets
constexpr std::size_t trials_of_means = 20'000;  // know the ends of an interval of 95 % to 2 % of u

constexpr std::size_t least_runs_of_t = 4;  // variance (n − 1)/(n − 3) s²/n

constexpr std::string_view type_a_keys[] = {"pooled", "t-scaled", "resampled"};  // in the order of TypeA

bool acts_as_noise(Effect effect) {
  return effect == Effect::reading || effect == Effect::run || effect == Effect::target ||
         effect == Effect::target_direction;
}

/// What the scatter of the approaches holds.
bool in_scatter(Effect effect) { return effect == Effect::reading || effect == Effect::run; }

/// Whether a run drawn anew would leave a cell with fewer readings.
bool resampling_would_lose_readings(const Series& series) {
  for (std::size_t i = 0; i < series.target_count(); ++i)
    for (Direction direction : {Direction::up, Direction::down})
      if (const std::size_t count = series.count(i, direction); count > 0 && count < series.run_count()) return true;
  return false;
}

/// Of those that have readings.
std::size_t fewest_in_a_cell(const Series& series) {
  std::size_t fewest = series.run_count();
  for (const Direction direction : {Direction::up, Direction::down})
    for (std::size_t target = 0; target < series.target_count(); ++target)
      if (const std::size_t count = series.count(target, direction); count > 0) fewest = std::min(fewest, count);
  return fewest;
}

/// What the method cannot treat.
Result<void> check(const Series& series, const UncertaintyInputs& inputs, TypeA type_a, Measurand measurand) {
  for (const UncertaintyInput& input : inputs.inputs)
    if (!input.distribution.standard_deviation())
      return fail(fmt::format("found the distribution \"{}\" of {}, expected one with a standard deviation",
                              input.distribution.text(), input.key));
  if (measurand != Measurand::this_machine) return {};
  if (series.run_count() < 2)
    return fail(
        "found a single approach per direction, expected at least two where the uncertainty of this machine is "
        "wanted: its scatter cannot be known (6.2)");
  const std::size_t fewest = fewest_in_a_cell(series);
  if (type_a == TypeA::t_scaled && fewest < least_runs_of_t)
    return fail(fmt::format(
        "found {} per direction, expected at least {} for the t distribution to have a standard deviation; 'pooled' "
        "needs two",
        counted(fewest, "approach", "approaches"), least_runs_of_t));
  if (type_a == TypeA::resampled && resampling_would_lose_readings(series))
    return fail(
        "found missing readings, expected every run at every target where runs are resampled; 'pooled' needs none");
  return {};
}

std::size_t index_of(const ParameterInfo* parameter) { return static_cast<std::size_t>(parameter - parameters); }

/// Of the parameters that a model has.
std::vector<double> measured_by(const TrialModel& model, const Evaluation& evaluation) {
  std::vector<double> values;
  for (const ParameterInfo* parameter : model.outputs())
    values.push_back((evaluation.parameters.*parameter->member)->in_native());
  return values;
}

SettledTrials settled(TrialModel model, const Series& series, const Evaluation& evaluation) {
  std::vector<double> measured = measured_by(model, evaluation);
  return {std::move(model), series, std::move(measured)};
}

/// Standard uncertainty of every parameter in a run of its own.
Result<Contribution> contribution(const SettledTrials& model, const MonteCarloOptions& options, std::string key,
                                  std::string title) {
  uncertainty::PropagationOptions alone = options.propagation;
  alone.trials = std::min(options.contribution_trials, alone.trials.value_or(options.contribution_trials));
  AXIOMETRY_TRY(const auto result, uncertainty::propagate(std::ref(model), model.trials().output_count(), alone));
  Contribution found{std::move(key), std::move(title), {}};
  const auto parameters_of = model.trials().outputs();
  for (std::size_t k = 0; k < parameters_of.size(); ++k) found.u[index_of(parameters_of[k])] = result.outputs[k].sd;
  return found;
}

/// Everything that trials of one test are drawn from.
struct Subject {
  const Test& test;
  const TestCourse& course;
  const Evaluation& evaluation;
  const UncertaintyInputs& inputs;
  const MonteCarloOptions& options;
  Measurand measurand;

  bool drifts() const { return measurand == Measurand::this_test || options.type_a == TypeA::pooled; }
  /// Of the readings as they were taken: a correction hides it.
  double step() const { return step_of(test.as_measured ? *test.as_measured : test.series); }
  NoiseQuestion question() const { return {test.metadata, test.series, course, inputs, drifts(), {}, step()}; }
};

/// The largest of all hypotheses about the noise, parameter by parameter.
Result<Contribution> input_contribution(const Subject& subject, std::size_t k) {
  const UncertaintyInput& input = subject.inputs.inputs[k];
  NoiseQuestion question = subject.question();
  question.only_input = k;
  Contribution largest{input.key, input.title, {}};
  const auto models = noise_models(question).models;
  for (std::size_t h = acts_as_noise(input.effect) && models.size() > 1 ? 1 : 0; h < models.size(); ++h) {
    const TrialModelOptions chosen{Measurand::this_test, subject.options.type_a, subject.options.seed, true, k};
    const SettledTrials model =
        settled({subject.test.series, subject.inputs, models[h], chosen}, subject.test.series, subject.evaluation);
    AXIOMETRY_TRY(const Contribution own, contribution(model, subject.options, input.key, input.title));
    for (std::size_t p = 0; p < std::size(parameters); ++p) largest.u[p] = std::max(largest.u[p], own.u[p]);
  }
  return largest;
}

Result<std::vector<Contribution>> contributions(const Subject& subject) {
  std::vector<Contribution> found;
  const MonteCarloOptions& options = subject.options;
  if (options.contribution_trials == 0) return found;
  for (std::size_t k = 0; k < subject.inputs.inputs.size(); ++k) {
    const UncertaintyInput& input = subject.inputs.inputs[k];
    if (subject.measurand == Measurand::this_machine && in_scatter(input.effect)) {
      found.push_back({input.key, input.title, {}});  // in "sampling" already
      continue;
    }
    AXIOMETRY_TRY(Contribution own, input_contribution(subject, k));
    found.push_back(std::move(own));
  }
  if (subject.measurand == Measurand::this_machine) {
    const UncertaintyInputs none;
    const NoiseModel exact{{}, {ReadingNoise{}}, nullptr};
    const TrialModelOptions chosen{subject.measurand, options.type_a, options.seed, true, std::nullopt};
    const SettledTrials model =
        settled({subject.test.series, none, exact, chosen}, subject.test.series, subject.evaluation);
    AXIOMETRY_TRY(Contribution own, contribution(model, options, "sampling", "Sampling of the approaches"));
    found.push_back(std::move(own));
  }
  return found;
}

/// The trials of every hypothesis, of the parameters or, where they are given, of other figures.
std::vector<SettledTrials> trials_of(const Subject& subject, std::span<const NoiseModel> noises,
                                     const TrialFigures* figures = nullptr) {
  std::vector<double> measured;
  if (figures != nullptr)
    for (const TrialFigure& figure : figures->figures) measured.push_back(figure.value);
  std::vector<SettledTrials> models;
  for (const NoiseModel& noise : noises) {
    const TrialModelOptions chosen{
        subject.measurand, subject.options.type_a, subject.options.seed, true, std::nullopt, figures};
    const TrialModel* const alike = models.empty() ? nullptr : &models.back().trials();
    TrialModel model(subject.test.series, subject.inputs, noise, chosen, alike);
    std::vector<double> values = figures != nullptr ? measured : measured_by(model, subject.evaluation);
    models.emplace_back(std::move(model), subject.test.series, std::move(values));
  }
  return models;
}

/// The means at the targets, by fewer trials: their distribution is plain.
Result<void> add_means(MonteCarlo& result, const Subject& subject, std::span<const SettledTrials> models) {
  if (subject.options.contribution_trials == 0) return {};
  uncertainty::PropagationOptions propagation = subject.options.propagation;
  propagation.trials = std::min(trials_of_means, propagation.trials.value_or(trials_of_means));
  const std::size_t count = subject.test.series.target_count();
  const auto targets = targets_of_means(count, most_means);
  result.mean_trials = *propagation.trials;
  AXIOMETRY_TRY(result.means, mean_distributions(models, subject.evaluation, targets, propagation));
  if (targets.size() < count)
    result.notes.push_back(
        fmt::format("The means of {} of the {} targets have an interval here", targets.size(), count));
  return {};
}

Result<void> propagate_hypotheses(MonteCarlo& result, const Subject& subject, std::span<const SettledTrials> models) {
  const TrialModel& first = models.front().trials();
  AXIOMETRY_TRY(HypothesesRun run,
                run_hypotheses(models, measured_by(first, subject.evaluation), subject.options.propagation));
  result.trials = run.trials;
  result.adaptive = run.adaptive;
  std::vector<std::string_view> constant;
  for (std::size_t k = 0; k < run.distributions.size(); ++k) {
    const ParameterInfo& parameter = *first.outputs()[k];
    ParameterDistribution& d = run.distributions[k];
    if (d.summary.sd == 0.0) {
      constant.push_back(parameter.symbol);
      continue;
    }
    result.stable = result.stable && d.summary.stable;
    if (!may_be_below_0(parameter.key)) d.low = std::max(d.low, 0.0);  // moved back it may lie below
    result.distributions[index_of(&parameter)] = std::move(d);
  }
  if (!constant.empty()) result.notes.push_back(no_claim_note(constant));
  return {};
}

/// Why nothing is drawn of readings that no normal scatter explains: they break the models. Empty where there are none.
std::string refusal_where_outliers(const Subject& subject) {
  return reason_of(gross_errors(subject.test.series, subject.course, subject.step()), subject.test);
}

/// Whether it did.
bool refuse_where_outliers(std::span<std::optional<ParameterDistribution>> distributions,
                           std::vector<std::string>& notes, const Subject& subject) {
  const std::string reason = refusal_where_outliers(subject);
  if (reason.empty()) return false;
  for (auto& d : distributions)
    if (d) d->refusal = reason;
  notes.push_back(std::string(refusal_sentence) + reason);
  return true;
}

/// Noise is treated as normal, whatever its distribution.
std::vector<std::string> notes_on(const UncertaintyInputs& inputs, Measurand measurand, TypeA type_a) {
  std::vector<std::string> notes = inputs.notes;
  if (std::string doubt = doubt_of_type_a(measurand, type_a); !doubt.empty()) notes.push_back(std::move(doubt));
  if (measurand == Measurand::this_machine &&
      std::ranges::any_of(inputs.inputs, [](const UncertaintyInput& input) { return in_scatter(input.effect); }))
    notes.emplace_back(scatter_note);
  for (const UncertaintyInput& input : inputs.inputs)
    if (acts_as_noise(input.effect) && input.key != "environmental_variation" &&
        !std::holds_alternative<uncertainty::Normal>(input.distribution.form()))
      notes.push_back(fmt::format("{} acts as noise of the readings and is taken as normal with its standard deviation",
                                  input.title));
  return notes;
}

/// What the interval holds for, and what it assumes.
void note_hypotheses(std::vector<std::string>& notes, std::span<const NoiseHypothesis> hypotheses) {
  if (hypotheses.size() < 2) return;
  for (const NoiseHypothesis& hypothesis : hypotheses) {
    if (hypothesis.refuted)
      notes.push_back(fmt::format("Noise refuted by the readings ({}): {}; {}", format_chance(*hypothesis.p),
                                  hypothesis.title, hypothesis.reason));
    else if (hypothesis.reason.empty())
      notes.push_back(fmt::format("The interval holds for: {}", hypothesis.title));
    else
      notes.push_back(fmt::format("The interval holds for: {}; {}", hypothesis.title, hypothesis.reason));
  }
}

}  // namespace

std::string_view type_a_key(TypeA type_a) { return type_a_keys[static_cast<std::size_t>(type_a)]; }

std::optional<TypeA> find_type_a(std::string_view key) {
  const auto found = std::ranges::find(type_a_keys, key);
  if (found == std::end(type_a_keys)) return std::nullopt;
  return static_cast<TypeA>(found - std::begin(type_a_keys));
}

Result<std::optional<MonteCarlo>> monte_carlo(const Test& test, const Evaluation& evaluation,
                                              const MonteCarloOptions& options) {
  const Measurand measurand = measurand_of(test.metadata);
  AXIOMETRY_TRY(const UncertaintyInputs inputs, uncertainty_inputs(test.metadata, test.series, test.provenance.stated));
  if (inputs.inputs.empty() && measurand == Measurand::this_test) return std::nullopt;
  AXIOMETRY_TRY_VOID(check(test.series, inputs, options.type_a, measurand));
  const TestCourse course = course_of(test);
  const Subject subject{test, course, evaluation, inputs, options, measurand};
  NoiseModels noise = noise_models(subject.question());
  MonteCarlo result{measurand,
                    options.type_a,
                    options.seed,
                    0,
                    false,
                    true,
                    options.propagation.coverage,
                    {},
                    inputs.inputs,
                    {},
                    notes_on(inputs, measurand, options.type_a),
                    std::move(noise.hypotheses),
                    {},
                    0};
  result.notes.insert(result.notes.end(), noise.notes.begin(), noise.notes.end());
  note_hypotheses(result.notes, result.hypotheses);
  const std::vector<SettledTrials> models = trials_of(subject, noise.models);
  AXIOMETRY_TRY_VOID(propagate_hypotheses(result, subject, models));
  const bool refused = (models.size() > 1 || measurand == Measurand::this_machine) &&
                       refuse_where_outliers(result.distributions, result.notes, subject);
  if (!refused) AXIOMETRY_TRY_VOID(add_means(result, subject, models));
  AXIOMETRY_TRY(result.contributions, contributions(subject));
  return result;
}

Result<std::optional<FigureTrials>> monte_carlo(const Test& test, const Evaluation& evaluation,
                                                const TrialFigures& figures, const MonteCarloOptions& options) {
  const Measurand measurand = measurand_of(test.metadata);
  AXIOMETRY_TRY(const UncertaintyInputs inputs, uncertainty_inputs(test.metadata, test.series, test.provenance.stated));
  if (figures.figures.empty() || (inputs.inputs.empty() && measurand == Measurand::this_test)) return std::nullopt;
  AXIOMETRY_TRY_VOID(check(test.series, inputs, options.type_a, measurand));
  const TestCourse course = course_of(test);
  const Subject subject{test, course, evaluation, inputs, options, measurand};
  const NoiseModels noise = noise_models(subject.question());
  const std::vector<SettledTrials> models = trials_of(subject, noise.models, &figures);
  std::vector<double> measured;
  for (const TrialFigure& figure : figures.figures) measured.push_back(figure.value);
  AXIOMETRY_TRY(HypothesesRun run, run_hypotheses(models, measured, options.propagation));
  FigureTrials result{measurand,  options.seed,
                      run.trials, run.adaptive,
                      true,       options.propagation.coverage,
                      {},         notes_on(inputs, measurand, options.type_a)};
  result.notes.insert(result.notes.end(), noise.notes.begin(), noise.notes.end());
  note_hypotheses(result.notes, noise.hypotheses);
  for (ParameterDistribution& d : run.distributions) {
    auto& kept = result.distributions.emplace_back();
    if (d.summary.sd == 0.0) continue;
    result.stable = result.stable && d.summary.stable;
    kept = std::move(d);
  }
  if (noise.models.size() > 1 || measurand == Measurand::this_machine)
    refuse_where_outliers(result.distributions, result.notes, subject);
  return result;
}

}  // namespace axiometry::iso230_2
