// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/mean_distributions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiometry::iso230_2 {
namespace {

constexpr std::size_t rows_per_target = 3;   // ↑, ↓, both
constexpr double rounding_of_means = 1e-12;  // share of the largest number: thousands of roundings

/// By one output of every hypothesis.
std::optional<MeanInterval> interval_of(std::vector<uncertainty::OutputSummary> by_hypothesis, double measured,
                                        double position) {
  ParameterDistribution d;
  d.value = measured;
  d.by_hypothesis = std::move(by_hypothesis);
  find_envelope(d);
  // Errors of length grow with the position: 1 µm at 1 mm is far beyond any of them.
  if (d.summary.sd <= rounding_of_means * std::max(std::abs(position), std::abs(measured))) return std::nullopt;
  return MeanInterval{measured, d.summary.mean, d.summary.sd, d.low, d.high};
}

}  // namespace

std::vector<std::size_t> targets_of_means(std::size_t target_count, std::size_t most) {
  std::vector<std::size_t> targets;
  const std::size_t count = std::min(target_count, most);
  for (std::size_t k = 0; k < count; ++k) targets.push_back(count < 2 ? k : k * (target_count - 1) / (count - 1));
  return targets;
}

Result<std::vector<MeanDistribution>> mean_distributions(std::span<const SettledTrials> models,
                                                         const Evaluation& evaluation,
                                                         std::span<const std::size_t> targets,
                                                         const uncertainty::PropagationOptions& options) {
  std::vector<uncertainty::MonteCarloResult> all;
  for (const SettledTrials& model : models) {
    const auto block = [&](std::uint64_t number, uncertainty::BlockOutputs outputs) {
      model.trials().draw_means(number, targets, outputs);
    };
    AXIOMETRY_TRY(auto own, uncertainty::propagate(block, rows_per_target * targets.size(), options));
    for (uncertainty::OutputSummary& output : own.outputs) {  // hundreds of them, of which four numbers are wanted
      output.distribution = {};
      output.histogram = {};
    }
    all.push_back(std::move(own));
  }
  std::vector<MeanDistribution> found;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const PositionResult& result = evaluation.positions[targets[k]];
    const auto interval = [&](std::size_t row,
                              const std::optional<Deviation>& measured) -> std::optional<MeanInterval> {
      if (!measured) return std::nullopt;
      std::vector<uncertainty::OutputSummary> own;
      for (auto& model : all) own.push_back(std::move(model.outputs[rows_per_target * k + row]));
      return interval_of(std::move(own), measured->in_native(), result.target.in_native());
    };
    found.push_back(
        {result.target, interval(0, result.mean_up), interval(1, result.mean_down), interval(2, result.mean)});
  }
  return found;
}

}  // namespace axiometry::iso230_2
