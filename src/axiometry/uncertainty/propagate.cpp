// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/propagate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/text.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/uncertainty/derivatives.h"

namespace axiometry::uncertainty {
namespace {

Result<void> check_inputs(std::span<const InputQuantity> inputs, double coverage) {
  if (!(coverage > 0.0 && 0.5 + 0.5 * coverage < 1.0))
    return fail(fmt::format("found the coverage probability {}, expected one between 0 and 1", coverage));
  for (const InputQuantity& input : inputs) {
    const std::string name = text::quoted(input.name);
    if (!std::isfinite(input.estimate))
      return fail(fmt::format("found the estimate {} of {}, expected a finite one", input.estimate, name));
    if (!(input.standard_uncertainty >= 0.0) || std::isinf(input.standard_uncertainty))
      return fail(fmt::format("found the standard uncertainty {} of {}, expected one not below 0",
                              input.standard_uncertainty, name));
    if (!(input.degrees_of_freedom > 0.0))
      return fail(
          fmt::format("found {} degrees of freedom of {}, expected more than 0", input.degrees_of_freedom, name));
  }
  return {};
}

/// One row per output.
using Jacobian = std::vector<std::vector<InputContribution>>;

Jacobian given(const JacobianFunction& function, std::size_t outputs, std::span<const double> x) {
  std::vector<double> flat(outputs * x.size());
  function(x, flat);
  Jacobian jacobian(outputs, std::vector<InputContribution>(x.size()));
  for (std::size_t k = 0; k < outputs; ++k)
    for (std::size_t i = 0; i < x.size(); ++i) jacobian[k][i].sensitivity = flat[k * x.size() + i];
  return jacobian;
}

Result<Jacobian> computed(const ModelFunction& model, std::size_t outputs, std::span<const InputQuantity> inputs,
                          std::span<const double> x) {
  Jacobian jacobian(outputs, std::vector<InputContribution>(inputs.size()));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    double step = inputs[i].standard_uncertainty;
    // An input without uncertainty contributes nothing; its sensitivity is shown all the same.
    if (x[i] + step == x[i]) step = std::max(std::abs(x[i]) * 1e-3, 1e-3);
    const auto column = first_derivatives(model, outputs, x, i, step);
    for (std::size_t k = 0; k < outputs; ++k) {
      if (!std::isfinite(column[k].error) || !std::isfinite(column[k].value))
        return fail(
            fmt::format("found no finite values of output {} near the estimate of {}, expected a model that can "
                        "be evaluated within its standard uncertainty",
                        k + 1, text::quoted(inputs[i].name)));
      jacobian[k][i].sensitivity = column[k].value;
      jacobian[k][i].sensitivity_error = column[k].error;
    }
  }
  return jacobian;
}

/// Σ_ij a_i r_ij b_j over contributions.
double covariance(const std::vector<InputContribution>& a, const std::vector<InputContribution>& b,
                  const Correlation& r) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) sum += a[i].contribution * r(i, j) * b[j].contribution;
  return sum;
}

/// Welch-Satterthwaite, G.2b, or nothing where it does not hold.
std::optional<double> effective_degrees(const Budget& budget, std::span<const InputQuantity> inputs,
                                        const Correlation& r) {
  double denominator = 0.0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double contribution = budget.contributions[i].contribution;
    if (contribution == 0.0 || std::isinf(inputs[i].degrees_of_freedom)) continue;
    for (std::size_t j = 0; j < inputs.size(); ++j)
      if (j != i && r(i, j) != 0.0 && budget.contributions[j].contribution != 0.0) return std::nullopt;
    denominator += std::pow(contribution / budget.standard_uncertainty, 4) / inputs[i].degrees_of_freedom;
  }
  return denominator > 0.0 ? 1.0 / denominator : std::numeric_limits<double>::infinity();
}

double coverage_factor(std::optional<double> degrees_of_freedom, double coverage) {
  const double nu = degrees_of_freedom.value_or(std::numeric_limits<double>::infinity());
  // ν_eff of 15.9999999999 from inputs that make 16 is 16.
  const double whole = nu < 1.0 ? nu : std::floor(nu * (1.0 + 1e-12));
  return numeric::student_t_quantile((1.0 + coverage) / 2, whole);
}

void add_second_order(std::vector<Budget>& budgets, const ModelFunction& model, std::span<const InputQuantity> inputs,
                      const Correlation& correlation, std::span<const double> x) {
  const std::size_t n = inputs.size();
  std::vector<double> transform(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      transform[i * n + j] = inputs[i].standard_uncertainty * correlation.factor_row(i)[j];
  const auto curvature = curvatures(model, budgets.size(), x, transform);
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    Budget& b = budgets[k];
    const double variance = b.standard_uncertainty * b.standard_uncertainty + curvature[k].variance;
    SecondOrder second{b.estimate + curvature[k].diagonal / 2, std::sqrt(std::max(variance, 0.0)), {}};
    const double U = b.coverage_factor * second.standard_uncertainty;
    second.interval = {second.estimate - U, second.estimate + U};
    b.second_order = second;
  }
}

}  // namespace

InputQuantity InputQuantity::of(std::string name, const Distribution& distribution) {
  if (const auto* t = std::get_if<StudentT>(&distribution.form()))
    return {std::move(name), t->location, t->scale, t->degrees_of_freedom};
  return {std::move(name), distribution.mean(), distribution.standard_deviation().value()};
}

double LawResult::correlation(std::size_t k, std::size_t l) const {
  const double u_k = outputs[k].standard_uncertainty, u_l = outputs[l].standard_uncertainty;
  return u_k > 0.0 && u_l > 0.0 ? covariance[k * outputs.size() + l] / (u_k * u_l) : 0.0;
}

Result<LawResult> law_of_propagation(const ModelFunction& model, std::size_t outputs,
                                     std::span<const InputQuantity> inputs, const Correlation& correlation,
                                     const LawOptions& options) {
  AXIOMETRY_CONTRACT(outputs > 0 && correlation.size() == inputs.size());
  AXIOMETRY_TRY_VOID(check_inputs(inputs, options.coverage));
  std::vector<double> x, y(outputs);
  for (const InputQuantity& input : inputs) x.push_back(input.estimate);
  model(x, y);
  for (std::size_t k = 0; k < outputs; ++k)
    if (!std::isfinite(y[k]))
      return fail(fmt::format("found the value {} of output {} at the estimates, expected a finite one",
                              std::isnan(y[k]) ? std::abs(y[k]) : y[k], k + 1));  // no "-nan"
  AXIOMETRY_TRY(Jacobian jacobian,
                options.jacobian ? given(options.jacobian, outputs, x) : computed(model, outputs, inputs, x));
  LawResult result;
  for (std::size_t k = 0; k < outputs; ++k) {
    Budget& budget = result.outputs.emplace_back();
    for (std::size_t i = 0; i < inputs.size(); ++i)
      jacobian[k][i].contribution = jacobian[k][i].sensitivity * inputs[i].standard_uncertainty;
    for (std::size_t l = 0; l <= k; ++l) result.covariance.push_back(covariance(jacobian[k], jacobian[l], correlation));
    budget.estimate = y[k];
    budget.standard_uncertainty = std::sqrt(std::max(result.covariance.back(), 0.0));
    budget.contributions = jacobian[k];
    budget.degrees_of_freedom = effective_degrees(budget, inputs, correlation);
    budget.coverage_factor = coverage_factor(budget.degrees_of_freedom, options.coverage);
    budget.expanded_uncertainty = budget.coverage_factor * budget.standard_uncertainty;
    budget.interval = {y[k] - budget.expanded_uncertainty, y[k] + budget.expanded_uncertainty};
  }
  if (options.second_order) add_second_order(result.outputs, model, inputs, correlation, x);
  // The lower triangle becomes the whole matrix.
  std::vector<double> whole(outputs * outputs);
  for (std::size_t k = 0, next = 0; k < outputs; ++k)
    for (std::size_t l = 0; l <= k; ++l) whole[k * outputs + l] = whole[l * outputs + k] = result.covariance[next++];
  result.covariance = std::move(whole);
  return result;
}

}  // namespace axiometry::uncertainty
