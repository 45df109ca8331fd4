// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {

/// A choice among alternatives of given weights, made by one uniform number.
class WeightedChoice {
 public:
  WeightedChoice() = default;

  /// From logarithms of weights, which need not be normalised; −inf is a weight of zero, one must be finite.
  static WeightedChoice from_log_weights(std::span<const double> log_weights) {
    AXIOMETRY_CONTRACT(!log_weights.empty());
    const double largest = *std::ranges::max_element(log_weights);
    WeightedChoice choice;
    choice.cumulative_.reserve(log_weights.size());
    double sum = 0.0;
    for (double log_weight : log_weights) choice.cumulative_.push_back(sum += std::exp(log_weight - largest));
    for (double& c : choice.cumulative_) c /= sum;
    return choice;
  }

  std::size_t size() const { return cumulative_.size(); }

  /// The alternative that the number from (0, 1) falls on.
  std::size_t operator()(double uniform) const {
    const auto place = std::ranges::upper_bound(cumulative_, uniform);
    return std::min(static_cast<std::size_t>(place - cumulative_.begin()), cumulative_.size() - 1);
  }

  /// Probability of one alternative.
  double probability(std::size_t index) const {
    return cumulative_[index] - (index == 0 ? 0.0 : cumulative_[index - 1]);
  }

 private:
  std::vector<double> cumulative_;
};

}  // namespace axiometry::numeric
