// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/series/target_index.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace axiometry::formats {
namespace {
constexpr std::size_t few = 32;  // up to here looking through all is quicker than a table
}

std::uint32_t TargetIndex::append(double target) {
  last_ = static_cast<std::uint32_t>(targets_.size());
  targets_.push_back(target);
  changed_ = true;
  return last_;
}

std::uint32_t TargetIndex::search(double target) {
  const auto is_same = [target](double other) { return std::abs(other - target) <= same_target; };
  if (targets_.size() <= few) {
    const auto found = std::ranges::find_if(targets_, is_same);
    if (found != targets_.end()) return last_ = static_cast<std::uint32_t>(found - targets_.begin());
  } else {
    for (std::size_t k = numbers_.size(); k < targets_.size(); ++k)
      numbers_.emplace(targets_[k], static_cast<std::uint32_t>(k));
    const auto found = numbers_.lower_bound(target - same_target);
    if (found != numbers_.end() && is_same(found->first)) return last_ = found->second;
  }
  repeats_ = false;
  return append(target);
}

std::span<const std::uint32_t> TargetIndex::ranks() {
  if (!std::exchange(changed_, false) || ranked_ == targets_) return ranks_;
  std::vector<std::uint32_t> order(targets_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t k) { return targets_[k]; });
  ranks_.resize(order.size());
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) ranks_[order[rank]] = rank;
  ranked_ = targets_;
  return ranks_;
}

void TargetIndex::restart() {
  previous_.swap(targets_);
  targets_.clear();
  changed_ = true;
  numbers_.clear();
  repeats_ = true;
  last_ = 0;
}

}  // namespace axiometry::formats
