// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace axiometry::formats {

/// Targets not farther apart than this (mm or °) are one target: computed positions carry float noise, and
/// no axis is tested in steps of half a nanometre.
inline constexpr double same_target = 5e-7;

/// Numbers the distinct targets of a test in the order of their appearance. Readings come in runs along
/// the targets, and the next test mostly visits the same ones, so the neighbours of the last target and
/// the order of the previous test are tried before any search.
class TargetIndex {
 public:
  /// Number of a target, a new one when it was not there yet. Targets within same_target are one: the one met first.
  std::uint32_t number(double target) {
    const std::size_t n = targets_.size();
    if (last_ + 1 < n && targets_[last_ + 1] == target) return ++last_;
    if (last_ < n && targets_[last_] == target) return last_;
    if (last_ > 0 && targets_[last_ - 1] == target) return --last_;
    if (repeats_ && n < previous_.size() && previous_[n] == target) return append(target);
    return search(target);
  }

  /// Targets in the order of their numbers.
  std::span<const double> targets() const { return targets_; }

  /// For every number the rank of its target in ascending order. Asked again before another target comes, it is free.
  std::span<const std::uint32_t> ranks();

  /// Forgets the targets, for the next test.
  void restart();

 private:
  std::uint32_t append(double target);
  std::uint32_t search(double target);

  std::vector<double> targets_;
  std::vector<double> previous_;  // positions of the test before
  bool repeats_ = false;          // targets_ is the beginning of previous_, whose numbers are distinct
  std::uint32_t last_ = 0;
  std::map<double, std::uint32_t> numbers_;  // filled only when there are many targets
  std::vector<std::uint32_t> ranks_;
  std::vector<double> ranked_;  // the targets that ranks_ belongs to
  bool changed_ = true;         // targets_ may be others than ranked_
};

}  // namespace axiometry::formats
