// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
    choice.find_starts();
    return choice;
  }

  std::size_t size() const { return cumulative_.size(); }

  /// The alternative that the number from (0, 1) falls on.
  std::size_t operator()(double uniform) const {
    AXIOMETRY_CONTRACT(!starts_.empty());
    const auto part = static_cast<std::size_t>(uniform * parts_);  // exact: a power of 2
    std::size_t place = starts_[std::min(part, starts_.size() - 1)];
    while (place + 1 < cumulative_.size() && cumulative_[place] <= uniform) ++place;
    return place;
  }

  /// Probability of one alternative.
  double probability(std::size_t index) const {
    return cumulative_[index] - (index == 0 ? 0.0 : cumulative_[index - 1]);
  }

 private:
  /// Of every one of equal parts of (0, 1) the first alternative that its numbers may fall on (Chen and Asau 1974):
  /// with so many more parts than alternatives it nearly always is the one, which the processor then guesses.
  void find_starts() {
    starts_.resize(std::bit_ceil(parts_of_alternative * cumulative_.size()));
    parts_ = static_cast<double>(starts_.size());
    std::size_t place = 0;
    for (std::size_t part = 0; part < starts_.size(); ++part) {
      const double begin = static_cast<double>(part) / static_cast<double>(starts_.size());
      while (place + 1 < cumulative_.size() && cumulative_[place] <= begin) ++place;
      starts_[part] = static_cast<std::uint32_t>(place);
    }
  }

  static constexpr std::size_t parts_of_alternative = 4;

  std::vector<double> cumulative_;
  std::vector<std::uint32_t> starts_;
  double parts_ = 0.0;  ///< how many parts there are
};

}  // namespace axiometry::numeric
