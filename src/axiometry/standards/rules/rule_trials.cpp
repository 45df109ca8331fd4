// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/rule_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/standards/iso230_2/monte_carlo/trial_figures.h"

namespace axiometry::standards {
namespace {

using iso230_2::Measurand;

/// As A, E and M are (iso230_2::Effect::displacement). What has no counterpart is made of positions too.
bool lies_between_places(const RuleFigure& figure) {
  return figure.counterpart.empty() || figure.counterpart.starts_with('A') || figure.counterpart.starts_with('E') ||
         figure.counterpart.starts_with('M');
}

std::vector<ComparedFigure*> figures_with_value(RuleComparison& comparison) {
  std::vector<ComparedFigure*> all;
  for (ComparedRule& rule : comparison.rules)
    for (ComparedFigure& figure : rule.figures)
      if (figure.value) all.push_back(&figure);
  return all;
}

bool has_interval(const RuleComparison& comparison) {
  return std::ranges::any_of(comparison.rules, [](const ComparedRule& rule) {
    return std::ranges::any_of(rule.figures, [](const ComparedFigure& figure) { return figure.interval.has_value(); });
  });
}

/// Whether trials have no single readings.
bool draws_moments_alone(const Test& test, const iso230_2::MonteCarloOptions& options) {
  return iso230_2::measurand_of(test.metadata) == Measurand::this_machine &&
         options.type_a != iso230_2::TypeA::resampled;
}

Result<bool> states_shifts_of_runs(const Test& test) {
  AXIOMETRY_TRY(const iso230_2::UncertaintyInputs inputs,
                iso230_2::uncertainty_inputs(test.metadata, test.series, test.provenance.stated));
  return std::ranges::any_of(
      inputs.inputs, [](const iso230_2::UncertaintyInput& input) { return input.effect == iso230_2::Effect::run; });
}

/// Moved back the distribution of a hypothesis may lie below 0.
double lower_end(const RuleFigure& figure, double low) {
  return iso230_2::may_be_below_0(figure.key) ? low : std::max(low, 0.0);
}

void take_interval(ComparedFigure& figure, const std::optional<iso230_2::ParameterDistribution>& found,
                   bool has_no_readings) {
  if (figure.figure->of_single_readings && has_no_readings)
    figure.no_interval_because = no_single_readings;
  else if (!found)
    figure.no_interval_because = nothing_acts;
  else if (!found->refusal.empty())
    figure.no_interval_because = "no normal scatter explains a reading";
  else
    figure.interval = FigureInterval{Deviation::native(std::min(lower_end(*figure.figure, found->low), found->value)),
                                     Deviation::native(std::max(found->high, found->value)),
                                     Deviation::native(found->summary.sd), found->summary.stable};
}

}  // namespace

Result<void> add_intervals(RuleComparison& comparison, const Test& test, const iso230_2::MonteCarloOptions& options) {
  const std::vector<ComparedFigure*> figures = figures_with_value(comparison);
  const bool has_no_readings = draws_moments_alone(test, options);
  iso230_2::TrialFigures trial_figures;
  for (const ComparedFigure* each : figures)
    trial_figures.figures.push_back({each->value->in_native(), lies_between_places(*each->figure),
                                     each->figure->of_single_readings, each->figure->counts_from_zero});
  trial_figures.evaluate = [&](const Series& trial, const iso230_2::WantedFigures& wanted, std::span<double> values) {
    const iso230_2::Evaluation evaluation = iso230_2::evaluate(trial);
    const RuleCase c{test.metadata, trial, evaluation};
    for (std::size_t k = 0; k < figures.size(); ++k) {
      if (!wanted.has(trial_figures.figures[k])) continue;
      if (const RuleValue value = figures[k]->figure->value(c)) values[k] = value->in_native();
    }
  };
  AXIOMETRY_TRY(const auto found, iso230_2::monte_carlo(test, comparison.iso230_2.evaluation, trial_figures, options));
  comparison.trials_asked_for = true;
  if (!found) return {};
  AXIOMETRY_CONTRACT(found->distributions.size() == figures.size());
  comparison.trials =
      RuleTrials{found->measurand, found->seed, found->trials, found->stable, found->coverage, found->notes};
  for (std::size_t k = 0; k < figures.size(); ++k) take_interval(*figures[k], found->distributions[k], has_no_readings);
  if (std::ranges::any_of(
          figures, [](const ComparedFigure* each) { return each->interval && each->figure->counts_from_zero; })) {
    comparison.trials->notes.emplace_back(zero_left_out);
    AXIOMETRY_TRY(const bool stated, states_shifts_of_runs(test));
    if (found->measurand == Measurand::this_test && !stated) comparison.trials->notes.emplace_back(clamping_left_out);
    if (found->measurand == Measurand::this_machine && test.series.run_count() == 2)
      comparison.trials->notes.emplace_back(two_runs_tell_little);
  }
  comparison.trials->stable = std::ranges::all_of(
      figures, [](const ComparedFigure* each) { return !each->interval || each->interval->stable; });
  return {};
}

std::string uncertainty_statement(const RuleComparison& comparison) {
  if (!comparison.trials_asked_for) return std::string(no_uncertainty_stated);
  if (!comparison.trials) return std::string(no_uncertainty_known);
  if (!has_interval(comparison)) return std::string(no_uncertainty_found);
  const std::string probability = fmt::format("{:.6g} %", 100.0 * comparison.trials->coverage);
  return comparison.trials->measurand == Measurand::this_test
             ? fmt::format(
                   "Intervals of {} are for the figures of this test by the formulas as they are known here; "
                   "whether these are the rule's is told by the evidence alone",
                   probability)
             : fmt::format(
                   "Intervals of {} are for what this machine does in the long run by the formulas as they are "
                   "known here; whether these are the rule's is told by the evidence alone",
                   probability);
}

}  // namespace axiometry::standards
