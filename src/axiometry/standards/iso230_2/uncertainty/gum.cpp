// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: the paper stops at the mean deviations; the parameters are linearised here.
#include "axiometry/standards/iso230_2/uncertainty/gum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/uncertainty/gradient.h"
#include "axiometry/standards/iso230_2/uncertainty/gum_model.h"
#include "axiometry/standards/readings/thermal_expansion.h"

namespace axiometry::iso230_2 {
namespace {

double squared(double x) { return x * x; }

/// The derivatives of a parameter at one target, by direction.
struct TargetTerms {
  std::size_t target = 0;
  double by_mean[2] = {0.0, 0.0};
  double by_s[2] = {0.0, 0.0};
};

/// A gradient's terms, target by target, so that ↑ and ↓ cancel exactly where they do.
std::vector<TargetTerms> by_target(Gradient gradient) {
  std::ranges::stable_sort(gradient, {}, &CellTerm::target);
  std::vector<TargetTerms> result;
  for (const CellTerm& term : gradient) {
    if (result.empty() || result.back().target != term.target) result.push_back({term.target});
    const auto d = static_cast<std::size_t>(term.direction);
    result.back().by_mean[d] += term.by_mean;
    result.back().by_s[d] += term.by_s;
  }
  return result;
}

/// One parameter against all sources.
class ParameterBudget {
 public:
  ParameterBudget(const GumModel& model, const Series& series, const Evaluation& evaluation, Gradient gradient)
      : model_(model), series_(series), positions_(evaluation.positions), terms_(by_target(std::move(gradient))) {
    for (const TargetTerms& t : terms_)
      lever_m_ += (t.by_mean[0] + t.by_mean[1]) * positions_[t.target].target.in_native() / mm_per_m;
    lever_m_ = std::abs(lever_m_);
  }

  double lever_m() const { return lever_m_; }

  /// What the mean error of the station, for which the readings are not corrected, has moved the parameter by.
  double station_mean() const {
    return over_targets([&](std::size_t target) { return model_.station->mean_error(target); });
  }

  /// The standard uncertainty that an input gives.
  double of_input(std::size_t k) const {
    const UncertaintyInput& input = model_.inputs.inputs[k];
    const double u = model_.components[k].u;
    switch (input.effect) {
      case Effect::machine_expansion:
      case Effect::device_expansion: return lever_m_ * u * std::abs(sensitivity(input.effect).expansion);
      case Effect::machine_temperature:
      case Effect::device_temperature: return lever_m_ * u * std::abs(sensitivity(input.effect).difference);
      case Effect::alignment: return lever_m_ * model_.alignment->u;
      case Effect::station:
        if (!model_.station) return 0.0;
        return model_.station->sd_mm2[k] *
               std::abs(over_targets([&](std::size_t target) { return model_.station->sensitivity(target); }));
      case Effect::scale: return lever_m_ * u;
      case Effect::displacement: return is_displacement() ? u : 0.0;
      case Effect::target: return u * of_targets(model_.inputs.up_down_correlation);
      case Effect::target_direction: return u * of_targets(0.0);
      case Effect::run: return u * of_runs();
      case Effect::reading: return input.key == "environmental_variation" ? of_environment() : u * of_readings();
    }
    return 0.0;
  }

  /// Type A, cell by cell, as each has its own ν; the sum of all.
  double add_approaches(ComponentSum& sum) const {
    double squares = 0.0;
    for_each_cell([&](const CellTerm& term, std::span<const double>, double n, double, double s) {
      if (!model_.takes_scatter(static_cast<std::size_t>(n))) return;
      const double own = std::max(0.0, s * s - squared(model_.run_noise));
      const double square = squared(term.by_mean) * own / n + squared(term.by_s * s) / (2.0 * (n - 1.0));
      sum.add({std::sqrt(square), n - 1.0});
      squares += square;
    });
    return std::sqrt(squares);
  }

 private:
  ThermalState sensitivity(Effect effect) const {
    const bool machine = effect == Effect::machine_expansion || effect == Effect::machine_temperature;
    ThermalState state;
    for (const UncertaintyInput& input : model_.inputs.inputs) {
      if (input.effect == (machine ? Effect::machine_expansion : Effect::device_expansion))
        state.expansion = input.distribution.mean();
      if (input.effect == (machine ? Effect::machine_temperature : Effect::device_temperature))
        state.difference = input.distribution.mean();
    }
    return thermal_sensitivity(state);
  }

  /// What errors that are the same in both directions of a target do. A reversal takes no part in them.
  template <typename Error>
  double over_targets(const Error& error) const {
    double sum = 0.0;
    for (const TargetTerms& t : terms_)
      if (const double by_mean = t.by_mean[0] + t.by_mean[1]; by_mean != 0.0) sum += by_mean * error(t.target);
    return sum;
  }

  /// Whether the parameter is a distance between two places; a reversal is not.
  bool is_displacement() const {
    return std::ranges::any_of(terms_, [](const TargetTerms& t) { return t.by_mean[0] + t.by_mean[1] != 0.0; });
  }

  double of_targets(double r) const {
    double squares = 0.0;
    // (a + b)² − 2 (1 − r) a b, so that nothing remains of a reversal at r = 1
    for (const auto& [target, by_mean, by_s] : terms_)
      squares += squared(by_mean[0] + by_mean[1]) - 2.0 * (1.0 - r) * by_mean[0] * by_mean[1];
    return std::sqrt(std::max(0.0, squares));
  }

  /// Calls with each cell that has influence: its term, readings, n, mean and s.
  template <typename Function>
  void for_each_cell(const Function& function) const {
    for (const TargetTerms& t : terms_) {
      const PositionResult& p = positions_[t.target];
      for (Direction direction : {Direction::up, Direction::down}) {
        const auto d = static_cast<std::size_t>(direction);
        if (t.by_mean[d] == 0.0 && t.by_s[d] == 0.0) continue;
        const bool up = direction == Direction::up;
        const auto& s = up ? p.s_up : p.s_down;
        function(CellTerm{t.target, direction, t.by_mean[d], t.by_s[d]}, series_.cell(t.target, direction),
                 static_cast<double>(up ? p.count_up : p.count_down), (up ? p.mean_up : p.mean_down)->in_native(),
                 s ? s->in_native() : 0.0);
      }
    }
  }

  /// What n independent readings give: u/√n in a mean, u/√(n − 1) in s.
  double of_readings() const {
    double squares = 0.0;
    for_each_cell([&](const CellTerm& term, std::span<const double>, double n, double, double) {
      if (model_.takes_scatter(static_cast<std::size_t>(n))) return;
      squares += squared(term.by_mean) / n;
      if (n > 1.0) squares += squared(term.by_s) / (n - 1.0);
    });
    return std::sqrt(squares);
  }

  /// The scatter of this_machine holds its part in s.
  double of_environment() const {
    WeightedReadings sum{{}, of_readings()};
    for_each_cell([&](const CellTerm& term, std::span<const double> readings, double n, double mean, double s) {
      const bool in_s = !model_.takes_scatter(static_cast<std::size_t>(n)) && s > 0.0;
      const std::size_t cell = static_cast<std::size_t>(term.direction) * series_.target_count() + term.target;
      for (std::size_t j = 0; j < readings.size(); ++j) {
        if (std::isnan(readings[j])) continue;
        const double by_s = in_s ? term.by_s * (readings[j] - mean) / ((n - 1.0) * s) : 0.0;
        sum.terms.push_back({cell * series_.run_count() + j, term.by_mean / n + by_s});
      }
    });
    return model_.environment->of(sum);
  }

  /// Shifts that are common to a run: the derivative by each, over all cells that the run has. The scatter of
  /// this_machine holds their part in s.
  double of_runs() const {
    std::vector<double> derivatives(series_.run_count(), 0.0);
    for_each_cell([&](const CellTerm& term, std::span<const double> readings, double n, double mean, double s) {
      const bool in_s = !model_.takes_scatter(static_cast<std::size_t>(n)) && s > 0.0;
      for (std::size_t j = 0; j < readings.size(); ++j) {
        if (std::isnan(readings[j])) continue;
        derivatives[j] += term.by_mean / n;
        if (in_s) derivatives[j] += term.by_s * (readings[j] - mean) / ((n - 1.0) * s);
      }
    });
    double squares = 0.0;
    for (double derivative : derivatives) squares += derivative * derivative;
    // A range over the same runs leaves what rounding leaves.
    return squares < squared(1e-14) ? 0.0 : std::sqrt(squares);
  }

  const GumModel& model_;
  const Series& series_;
  const std::vector<PositionResult>& positions_;
  std::vector<TargetTerms> terms_;
  double lever_m_ = 0.0;
};

std::vector<GumSource> list_sources(const GumModel& model) {
  std::vector<GumSource> sources;
  const bool machine = model.measurand == Measurand::this_machine;
  for (std::size_t k = 0; k < model.inputs.inputs.size(); ++k) {
    const UncertaintyInput& input = model.inputs.inputs[k];
    const bool in_scatter = machine && (input.effect == Effect::reading || input.effect == Effect::run);
    std::string note = input.note;
    if (in_scatter) note += note.empty() ? "part of the scatter" : "; part of the scatter";
    sources.push_back({input.key, input.symbol, input.title, input.source, input.distribution.text(),
                       model.components[k].u, input.unit, std::move(note)});
  }
  const auto add_product = [&](const auto& factor, std::string_view key, std::string_view symbol) {
    if (const double u = thermal_product(factor); u > 0.0)
      sources.push_back({std::string(key), std::string(symbol), "Expansion coefficient and temperature together", "A.6",
                         "", u, "µm/m", "beyond eq. 15"});
  };
  add_product(model.machine_thermal, "machine_thermal_product", "α ΔT");
  add_product(model.device_thermal, "device_thermal_product", "α_D ΔT_D");
  if (model.alignment_mean > 0.0)
    sources.push_back({"alignment_mean", "1 − f_a", "Mean error of the alignment, not corrected", "21", "",
                       model.alignment_mean, "µm/m", ""});
  if (model.station)
    sources.push_back({"station_mean", "E Δ²", "Mean error of the station, not corrected", "Lee et al. 19", "",
                       model.station->mean_mm2, "mm²", ""});
  if (machine) sources.push_back({"approaches", "s", "Scatter of the approaches (type A)", "11, 12", "", {}, "", ""});
  return sources;
}

/// The budget of one parameter; its uncertainty is 0 when no source acts on it.
GumParameter propagate_parameter(const GumModel& model, const ParameterBudget& budget) {
  GumParameter result;
  ComponentSum sum;
  bool correlated = false;
  const auto add = [&](double u, double nu) {
    sum.add({u, nu});
    result.contributions.push_back(Deviation::native(u));
  };
  const double r = model.inputs.up_down_correlation;
  for (std::size_t k = 0; k < model.inputs.inputs.size(); ++k) {
    const UncertaintyInput& input = model.inputs.inputs[k];
    const double u = budget.of_input(k);
    add(u, model.components[k].degrees_of_freedom);
    const bool partly = r != 0.0 && std::abs(r) < 1.0 && input.effect == Effect::target;
    const bool common = model.measurand == Measurand::this_machine && input.effect == Effect::run;
    correlated = correlated || (u > 0.0 && (partly || common));
  }
  for (const auto* factor : {&model.machine_thermal, &model.device_thermal})
    if (const double u = thermal_product(*factor); u > 0.0) add(budget.lever_m() * u, infinite);
  if (model.alignment_mean > 0.0) add(budget.lever_m() * model.alignment_mean, infinite);
  if (model.station) add(std::abs(budget.station_mean()), infinite);
  if (model.measurand == Measurand::this_machine)
    result.contributions.push_back(Deviation::native(budget.add_approaches(sum)));
  result.uncertainty = sum.expanded(correlated);
  return result;
}

/// Of the targets that share an extreme, those whose budget has the largest u; the first of equal ones.
GumParameter widest(const GumModel& model, const Series& series, const Evaluation& evaluation,
                    const std::vector<Gradient>& tied) {
  constexpr double larger = 1.0 + 1e-9;  // more than another order of summing changes a budget
  GumParameter result;
  for (const Gradient& gradient : tied) {
    GumParameter parameter = propagate_parameter(model, ParameterBudget(model, series, evaluation, gradient));
    const double u = parameter.uncertainty.u.in_native();
    if (u > larger * result.uncertainty.u.in_native()) result = std::move(parameter);
  }
  return result;
}

/// Where the known noise is not small against the scatter, s is far from linear in it.
void note_noise(GumUncertainty& result, const GumModel& model, const Evaluation& evaluation) {
  double noise = model.run_noise;
  for (std::size_t k = 0; k < model.components.size(); ++k)
    if (model.inputs.inputs[k].effect == Effect::reading) noise = std::hypot(noise, model.components[k].u);
  double largest = 0.0;
  for (const PositionResult& p : evaluation.positions)
    for (const auto& s : {p.s_up, p.s_down}) largest = std::max(largest, s ? s->in_native() : 0.0);
  if (model.measurand == Measurand::this_machine) {
    if (noise > 0.0) result.notes.emplace_back(scatter_note);
  } else if (noise > 0.5 * largest && largest > 0.0) {
    result.notes.push_back(
        fmt::format("The known noise of a reading (u = {:.2g}) is not small against the scatter (s up to {:.2g}): to "
                    "first order A, R and their like are uncertain by less than they are, see the Monte Carlo method",
                    noise, largest));
  }
}

void note_factor(GumUncertainty& result, const std::optional<FactorUncertainty>& factor, std::string_view whose) {
  if (!factor || factor->u <= 0.0) return;
  result.notes.push_back(fmt::format(
      "Thermal factor of the {}: u = {:.4g} µm/m by equation 15, {:.4g} µm/m by its exact distribution; {}", whose,
      factor->u_linear, factor->u_exact,
      factor->u > factor->u_linear ? "the difference counts as a source of its own" : "the former is used"));
}

void add_notes(GumUncertainty& result, const GumModel& model, const Evaluation& evaluation) {
  note_factor(result, model.machine_thermal, "machine");
  note_factor(result, model.device_thermal, "device");
  note_noise(result, model, evaluation);
  if (model.environment && !model.environment->note().empty()) result.notes.push_back(model.environment->note());
  if (model.station)
    result.notes.push_back(
        "The length difference of the station grows with the square of its offset: to first order the squares are "
        "inputs with a mean and a standard deviation; the readings are not corrected for the mean, which counts as a "
        "source of its own");
  result.position_notes = result.notes.size();  // the notes up to here concern the positions
  const bool single = std::ranges::any_of(evaluation.positions,
                                          [](const PositionResult& p) { return p.count_up == 1 || p.count_down == 1; });
  if (model.measurand == Measurand::this_machine && single)
    result.notes.push_back("A single approach has no scatter: there the known noise counts alone");
  std::vector<std::string_view> without;
  for (const ParameterInfo& info : parameters)
    if (evaluation.parameters.*info.member && result.find(info.key) == nullptr) without.push_back(info.symbol);
  if (!without.empty()) result.notes.push_back(no_claim_note(without));
  if (std::ranges::any_of(result.parameters,
                          [](const auto& p) { return p.uncertainty.coverage == Coverage::correlated; }))
    result.notes.push_back("Some sources are correlated: effective degrees of freedom are not defined, and k = 2");
  result.notes.push_back(
      "The parameters are extremes; this method follows the targets that are extreme in this test and does not see the "
      "bias of extremes, see the Monte Carlo method");
}

}  // namespace

std::string_view coverage_key(Coverage coverage) {
  switch (coverage) {
    case Coverage::normal: return "normal";
    case Coverage::degrees_of_freedom: return "degrees-of-freedom";
    case Coverage::correlated: return "correlated";
  }
  return "";
}

const GumParameter* GumUncertainty::find(std::string_view key) const {
  const auto found = std::ranges::find_if(parameters, [&](const auto& p) { return p.parameter->key == key; });
  return found == parameters.end() ? nullptr : &*found;
}

Result<std::optional<GumUncertainty>> gum(const Test& test, const Evaluation& evaluation) {
  const Series& series = test.series;
  AXIOMETRY_TRY(UncertaintyInputs inputs, uncertainty_inputs(test.metadata, series, test.provenance.stated));
  const Measurand measurand = measurand_of(test.metadata);
  if (inputs.inputs.empty() && measurand == Measurand::this_test) return std::nullopt;
  const GumModel model = make_model(test, std::move(inputs), measurand);

  GumUncertainty result;
  result.measurand = measurand;
  result.up_down_correlation = model.inputs.up_down_correlation;
  result.machine_thermal = model.machine_thermal;
  result.device_thermal = model.device_thermal;
  result.alignment = model.alignment;
  result.sources = list_sources(model);
  result.positions = propagate_positions(model, series, evaluation);
  const auto gradients = parameter_gradients(evaluation);
  for (std::size_t k = 0; k < std::size(parameters); ++k) {
    const ParameterInfo& info = parameters[k];
    if (!(evaluation.parameters.*info.member)) continue;
    GumParameter parameter = widest(model, series, evaluation, gradients[k]);
    if (parameter.uncertainty.u.in_native() == 0.0) continue;
    parameter.parameter = &info;
    parameter.value = *(evaluation.parameters.*info.member);
    result.parameters.push_back(std::move(parameter));
  }
  result.notes = model.inputs.notes;
  add_notes(result, model, evaluation);
  return result;
}

}  // namespace axiometry::iso230_2
