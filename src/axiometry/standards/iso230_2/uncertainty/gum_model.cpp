// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/uncertainty/gum_model.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/standards/readings/alignment.h"
#include "axiometry/standards/readings/thermal_expansion.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double coverage = 2.0;           // k where nothing has finite ν
constexpr double exact_from = 1.01;        // exact u over that of eq. 15 from which the difference counts
constexpr double largest_useful_nu = 1e6;  // beyond, k is 2 to six digits

const UncertaintyInput* find(const UncertaintyInputs& inputs, Effect effect) {
  const auto found = std::ranges::find(inputs.inputs, effect, &UncertaintyInput::effect);
  return found == inputs.inputs.end() ? nullptr : &*found;
}

std::optional<FactorUncertainty> thermal(const UncertaintyInputs& inputs, Effect expansion, Effect temperature) {
  const UncertaintyInput* alpha = find(inputs, expansion);
  const UncertaintyInput* difference = find(inputs, temperature);
  if (alpha == nullptr || difference == nullptr) return std::nullopt;
  const ThermalState state{alpha->distribution.mean(), difference->distribution.mean()};
  const ThermalState u{component_of(*alpha).u, component_of(*difference).u};
  FactorUncertainty factor;
  factor.departure = thermal_departure(state);
  factor.u_linear = thermal_uncertainty(state, u);
  factor.u_exact = thermal_moments(alpha->distribution, difference->distribution).standard_deviation;
  factor.u = factor.u_exact > exact_from * factor.u_linear ? factor.u_exact : factor.u_linear;
  return factor;
}

std::optional<StationModel> station(const UncertaintyInputs& inputs, const Series& series) {
  if (!inputs.station) return std::nullopt;
  StationModel model{StationErrors(series.targets(), *inputs.station), 0.0, {}};
  for (const UncertaintyInput& input : inputs.inputs) {
    const bool acts = input.effect == Effect::station;
    const SquareMoments moments = acts ? square_moments(input.distribution) : SquareMoments{};
    model.mean_mm2 += moments.mean;
    model.sd_mm2.push_back(moments.standard_deviation.value_or(0.0));
  }
  return model.mean_mm2 > 0.0 ? std::optional(std::move(model)) : std::nullopt;
}

}  // namespace

Component component_of(const UncertaintyInput& input) {
  const auto* t = std::get_if<uncertainty::StudentT>(&input.distribution.form());
  if (t != nullptr && input.effect > Effect::station) return {t->scale, t->degrees_of_freedom};
  return {input.distribution.standard_deviation().value_or(0.0), infinite};
}

void ComponentSum::add(Component component) {
  const double square = component.u * component.u;
  squares_ += square;
  fourth_powers_ += square * square / component.degrees_of_freedom;
}

double ComponentSum::u() const { return std::sqrt(squares_); }

ExpandedUncertainty ComponentSum::expanded(bool correlated) const {
  ExpandedUncertainty result;
  result.u = Deviation::native(u());
  result.k = coverage;
  if (has_finite()) result.coverage = correlated ? Coverage::correlated : Coverage::degrees_of_freedom;
  if (result.coverage == Coverage::degrees_of_freedom) {
    const double nu = squares_ * squares_ / fourth_powers_;
    result.effective_degrees_of_freedom = nu;
    // The probability of ± 2 u of a normal distribution, so that k tends to 2 as ν grows.
    if (nu < largest_useful_nu) result.k = numeric::student_t_quantile(numeric::normal_probability(coverage), nu);
  }
  result.U = Deviation::native(result.k * u());
  return result;
}

GumModel make_model(const Test& test, UncertaintyInputs inputs, Measurand measurand) {
  GumModel model;
  model.measurand = measurand;
  model.inputs = std::move(inputs);
  model.machine_thermal = thermal(model.inputs, Effect::machine_expansion, Effect::machine_temperature);
  model.device_thermal = thermal(model.inputs, Effect::device_expansion, Effect::device_temperature);
  if (const UncertaintyInput* angle = find(model.inputs, Effect::alignment)) {
    const FactorMoments moments = alignment_moments(angle->distribution);
    const double u = moments.standard_deviation;
    model.alignment = FactorUncertainty{moments.mean, u, u, u};
    model.alignment_mean = -moments.mean / model.alignment_factor();
  }
  model.station = station(model.inputs, test.series);
  model.expansion_in_readings = test.metadata.nde.applied != true;
  for (const UncertaintyInput& input : model.inputs.inputs) {
    model.components.push_back(component_of(input));
    const double u = model.components.back().u;
    if (input.effect == Effect::run) model.run_noise = std::hypot(model.run_noise, u);
    if (input.key == "environmental_variation") model.environment.emplace(test, model.inputs, u);
  }
  return model;
}

double thermal_product(const std::optional<FactorUncertainty>& factor) {
  if (!factor || factor->u <= factor->u_linear) return 0.0;
  return std::sqrt((factor->u - factor->u_linear) * (factor->u + factor->u_linear));
}

}  // namespace axiometry::iso230_2
