// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"

namespace axiometry::testing_support {

/// A histogram with the shape (1 − z²)², whole numbers, the same on every machine.
inline uncertainty::Histogram round_histogram(double lower, double width) {
  constexpr int bins = 40;
  uncertainty::Histogram histogram{lower, width / bins, {}};
  for (int k = 0; k < bins; ++k) {
    const double z = (k + 0.5) / bins * 2.0 - 1.0;
    histogram.counts.push_back(static_cast<std::uint64_t>(std::round(1000.0 * (1.0 - z * z) * (1.0 - z * z))));
  }
  return histogram;
}

/// Numbers of plausible sizes for every parameter that exists, so that what is shown of them does not hang on the
/// method itself: the mean is 5 % below the value and u 8 % of it; two inputs contribute, one of them alone to R.
inline iso230_2::MonteCarlo made_up_monte_carlo(const iso230_2::Evaluation& evaluation) {
  iso230_2::MonteCarlo result;
  result.seed = 7;
  result.trials = 1'000'000;
  result.adaptive = true;
  result.stable = true;
  result.contributions = {{"machine_temperature", "Temperature of the machine, less 20 °C", {}},
                          {"environmental_variation", "Environmental variation of a reading", {}}};
  result.inputs.push_back({"machine_temperature", "ΔT", "Temperature of the machine, less 20 °C", "16, A.5",
                           iso230_2::Effect::machine_temperature,
                           uncertainty::Distribution::make(uncertainty::Uniform{0.9, 1.1}).value(), "°C", "assumed"});
  result.notes = {"made up"};
  result.hypotheses = {{"white", "noise as it is stated", false, {}, ""}};
  for (std::size_t p = 0; p < std::size(iso230_2::parameters); ++p) {
    const auto& parameter = iso230_2::parameters[p];
    const auto& value = evaluation.parameters.*parameter.member;
    if (!value) continue;
    const double size = value->in_native();
    const double u = 0.08 * std::abs(size);
    const double mean = 0.95 * size;
    uncertainty::OutputSummary summary;
    summary.mean = mean;
    summary.sd = u;
    summary.symmetric = {mean - 1.9 * u, mean + 2.0 * u};
    summary.shortest = {mean - 2.0 * u, mean + 1.8 * u};
    summary.tolerance = uncertainty::numerical_tolerance(u, 2);
    summary.stable = true;
    summary.histogram =
        u == 0.0 ? uncertainty::Histogram{size, 0.0, {result.trials}} : round_histogram(mean - 3.3 * u, 6.6 * u);
    iso230_2::ParameterDistribution& distribution = result.distributions[p].emplace();
    distribution.value = size;
    distribution.low = summary.symmetric.lower;
    distribution.high = summary.symmetric.upper;
    distribution.by_hypothesis = {summary};
    distribution.summary = std::move(summary);
    const bool is_repeatability = parameter.key.starts_with('R');
    result.contributions[0].u[p] = is_repeatability ? 0.0 : 0.8 * u;
    result.contributions[1].u[p] = is_repeatability ? u : 0.6 * u;
  }
  return result;
}

}  // namespace axiometry::testing_support
