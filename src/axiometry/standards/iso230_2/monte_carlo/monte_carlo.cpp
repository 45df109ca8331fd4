// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/monte_carlo/gross_errors.h"
#include "axiometry/standards/iso230_2/monte_carlo/trials.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"
#include "axiometry/standards/readings/test_course.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double first_share = 0.97;  // 20 000 trials know u to 1 %, of heavy tails to 2 %

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
  if (type_a == TypeA::t_scaled && series.run_count() < least_runs_of_t)
    return fail(fmt::format(
        "found {} approaches per direction, expected at least {} for the t distribution to have a standard deviation; "
        "'pooled' needs two",
        series.run_count(), least_runs_of_t));
  if (type_a == TypeA::resampled && resampling_would_lose_readings(series))
    return fail(
        "found missing readings, expected every run at every target where runs are resampled; 'pooled' needs none");
  return {};
}

std::size_t index_of(const ParameterInfo* parameter) { return static_cast<std::size_t>(parameter - parameters); }

/// Trials in which a parameter that nothing acts on keeps its measured value to the last digit. Else rounding alone
/// would make it uncertain by some 1e-16, which no adaptive run can settle and no decision may rest on.
class SettledTrials {
 public:
  SettledTrials(TrialModel model, const Series& series, const Evaluation& evaluation) : model_(std::move(model)) {
    for (const ParameterInfo* parameter : model_.outputs())
      measured_.push_back((evaluation.parameters.*parameter->member)->in_native());
    double largest = 0.0;  // errors of length grow with the position: 1 µm at 1 mm is far beyond any of them
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      largest = std::max(largest, std::abs(series.targets()[i].in_native()));
      for (Direction direction : {Direction::up, Direction::down})
        for (double x : series.cell(i, direction))
          if (!std::isnan(x)) largest = std::max(largest, std::abs(x));
    }
    slack_ = rounding * largest;
  }

  std::span<const ParameterInfo* const> outputs() const { return model_.outputs(); }
  const TrialModel& trials() const { return model_; }

  void operator()(std::uint64_t block, uncertainty::BlockOutputs outputs) const {
    model_(block, outputs);
    for (std::size_t k = 0; k < measured_.size(); ++k) {
      const auto row = outputs.row(k);
      const auto settled = [&](double x) { return std::abs(x - measured_[k]) <= slack_; };
      if (std::ranges::all_of(row, settled)) std::ranges::fill(row, measured_[k]);
    }
  }

 private:
  static constexpr double rounding = 1e-12;  // of the largest number: thousands of roundings, nothing that is measured
  TrialModel model_;
  std::vector<double> measured_;
  double slack_ = 0.0;
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
    const SettledTrials model({subject.test.series, subject.inputs, models[h], chosen}, subject.test.series,
                              subject.evaluation);
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
    const SettledTrials model({subject.test.series, none, exact, chosen}, subject.test.series, subject.evaluation);
    AXIOMETRY_TRY(Contribution own, contribution(model, options, "sampling", "Sampling of the approaches"));
    found.push_back(std::move(own));
  }
  return found;
}

/// What holds for every hypothesis, and for noise of any size up to what it says.
void find_envelope(ParameterDistribution& d) {
  d.low = d.by_hypothesis.front().symmetric.lower;
  d.high = d.by_hypothesis.front().symmetric.upper;
  for (std::size_t h = 1; h < d.by_hypothesis.size(); ++h) {
    const uncertainty::OutputSummary& own = d.by_hypothesis[h];
    const double low = own.symmetric.lower + std::min(0.0, d.shift_of(h));
    const double high = own.symmetric.upper + std::max(0.0, d.shift_of(h));
    if (low < d.low) {
      d.low = low;
      d.low_from = h;
    }
    if (high > d.high) {
      d.high = high;
      d.high_from = h;
    }
    if (own.sd > d.by_hypothesis[d.summary_from].sd) d.summary_from = h;
  }
  d.summary = d.by_hypothesis[d.summary_from];
}

/// What is stated has the digits of the largest u and of half the widest interval of all hypotheses: none needs to be
/// known better. `share` of both sizes counts.
void widen(uncertainty::LeastTolerance& tolerance, const uncertainty::OutputSummary& own, int digits,
           double share = 1.0) {
  const double half = 0.5 * (own.symmetric.upper - own.symmetric.lower);
  tolerance.u = std::max(tolerance.u, uncertainty::numerical_tolerance(share * own.sd, digits));
  tolerance.ends = std::max(tolerance.ends, uncertainty::numerical_tolerance(share * half, digits));
}

/// That of every output, from no more trials than tell how large it is, and of a little less: what is found in the end
/// may be just below a power of ten that these trials were above.
Result<std::vector<uncertainty::LeastTolerance>> stated_tolerances(std::span<const SettledTrials> models,
                                                                   uncertainty::MonteCarloOptions options) {
  options.trials = 2 * uncertainty::block_size;
  std::vector<uncertainty::LeastTolerance> tolerances(models.front().outputs().size());
  for (const SettledTrials& model : models) {
    AXIOMETRY_TRY(const auto own, uncertainty::propagate(std::cref(model), tolerances.size(), options));
    for (std::size_t k = 0; k < tolerances.size(); ++k)
      widen(tolerances[k], own.outputs[k], options.digits, first_share);
  }
  return tolerances;
}

/// Whether all of them are known as well as that, after however many trials.
bool is_stable(std::span<const uncertainty::OutputSummary> hypotheses, int digits) {
  uncertainty::LeastTolerance tolerance;
  for (const uncertainty::OutputSummary& own : hypotheses) widen(tolerance, own, digits);
  return std::ranges::all_of(hypotheses, [&](const uncertainty::OutputSummary& own) {
    return own.sd == 0.0 || (2 * std::max(own.mean_error, own.sd_error) <= tolerance.u &&
                             2 * std::max(own.symmetric_error.lower, own.symmetric_error.upper) <= tolerance.ends);
  });
}

/// Trials of every hypothesis, one after the other.
Result<void> propagate_hypotheses(MonteCarlo& result, const Subject& subject, std::span<const NoiseModel> noises) {
  std::vector<SettledTrials> models;
  for (const NoiseModel& noise : noises) {
    const TrialModelOptions chosen{subject.measurand, subject.options.type_a, subject.options.seed, true, std::nullopt};
    const TrialModel* const alike = models.empty() ? nullptr : &models.back().trials();
    models.emplace_back(TrialModel(subject.test.series, subject.inputs, noise, chosen, alike), subject.test.series,
                        subject.evaluation);
  }
  const auto outputs = models.front().outputs();
  uncertainty::MonteCarloOptions propagation = subject.options.propagation;
  if (!propagation.trials && models.size() > 1) {
    AXIOMETRY_TRY(propagation.least_tolerances, stated_tolerances(models, propagation));
  }
  std::vector<uncertainty::MonteCarloResult> all;
  for (const SettledTrials& model : models) {
    AXIOMETRY_TRY(auto own, uncertainty::propagate(std::cref(model), outputs.size(), propagation));
    result.trials = std::max(result.trials, own.trials);
    result.adaptive = own.adaptive;
    all.push_back(std::move(own));
  }
  std::vector<std::string_view> constant;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const ParameterInfo& parameter = *outputs[k];
    ParameterDistribution d;
    d.value = (subject.evaluation.parameters.*parameter.member)->in_native();
    for (auto& own : all) d.by_hypothesis.push_back(std::move(own.outputs[k]));
    find_envelope(d);
    if (d.summary.sd == 0.0) {
      constant.push_back(parameter.symbol);
      continue;
    }
    if (d.by_hypothesis.size() > 1) d.summary.stable = is_stable(d.by_hypothesis, propagation.digits);
    result.stable = result.stable && d.summary.stable;
    result.distributions[index_of(&parameter)] = std::move(d);
  }
  if (!constant.empty()) result.notes.push_back(no_claim_note(constant));
  return {};
}

/// Readings that no normal scatter explains break the models of all that is drawn from it.
void refuse_where_outliers(MonteCarlo& result, const Subject& subject) {
  const auto found = gross_errors(subject.test.series, subject.course, subject.step());
  if (found.empty()) return;
  const GrossError& worst = found.front();
  std::string reason = fmt::format(
      "{} of run {} at {:.6g} {} departs by {:.3g} {} from the other approaches, {:.1f} times the standard deviation "
      "of "
      "such a departure",
      arrow(worst.direction), worst.run + 1, subject.test.series.targets()[worst.target].in_native(),
      position_unit(subject.test.metadata.axis.kind), worst.departure.in_native(),
      deviation_unit(subject.test.metadata.axis.kind), worst.factor);
  if (found.size() > 1) reason += fmt::format("; such readings: {}", found.size());
  for (auto& d : result.distributions)
    if (d) d->refusal = reason;
  result.notes.push_back(std::string(refusal_sentence) + reason);
}

/// Noise is treated as normal, whatever its distribution.
std::vector<std::string> notes_on(const UncertaintyInputs& inputs, Measurand measurand) {
  std::vector<std::string> notes = inputs.notes;
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
      notes.push_back(fmt::format("Noise refuted by the readings (p = {:.1g}): {}; {}", hypothesis.p.value_or(0.0),
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
                    notes_on(inputs, measurand),
                    std::move(noise.hypotheses)};
  result.notes.insert(result.notes.end(), noise.notes.begin(), noise.notes.end());
  note_hypotheses(result.notes, result.hypotheses);
  AXIOMETRY_TRY_VOID(propagate_hypotheses(result, subject, noise.models));
  if (noise.models.size() > 1 || measurand == Measurand::this_machine) refuse_where_outliers(result, subject);
  AXIOMETRY_TRY(result.contributions, contributions(subject));
  return result;
}

}  // namespace axiometry::iso230_2
