// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "axiometry/standards/iso230_2/monte_carlo/trials.h"

/// The trials of monte_carlo.h under one hypothesis and under all; private to it.
namespace axiometry::iso230_2 {

/// Trials in which a parameter that nothing acts on keeps its measured value to the last digit. Else rounding alone
/// would make it uncertain by some 1e-16, which no adaptive run can settle and no decision may rest on.
class SettledTrials {
 public:
  /// `measured`: a value for each output of the model.
  SettledTrials(TrialModel model, const Series& series, std::vector<double> measured);

  const TrialModel& trials() const { return model_; }

  void operator()(std::uint64_t block, uncertainty::BlockOutputs outputs) const;

 private:
  static constexpr double rounding = 1e-12;  // share of the largest number: thousands of roundings, nothing measured
  TrialModel model_;
  std::vector<double> measured_;
  double slack_ = 0.0;
};

/// From by_hypothesis (at least one) the ends of the interval that is stated and the summary: what holds for every
/// hypothesis, and for noise of any size up to what it says.
void find_envelope(ParameterDistribution& distribution);

/// Of every output what holds for all hypotheses; those with u = 0 too.
struct HypothesesRun {
  std::vector<ParameterDistribution> distributions;
  std::size_t trials = 0;
  bool adaptive = false;
};

/// Trials of every hypothesis, one after the other. Contract: models of the same outputs, at least one. Fails as
/// uncertainty::propagate() does.
Result<HypothesesRun> run_hypotheses(std::span<const SettledTrials> models, std::span<const double> measured,
                                     uncertainty::PropagationOptions propagation);

}  // namespace axiometry::iso230_2
