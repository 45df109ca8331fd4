// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace axiometry::numeric {

/// What each value of a sample finds the others to be like. All n values together take a time of n log n.
class LeaveOneOut {
 public:
  /// Contract: finite values.
  explicit LeaveOneOut(std::vector<double> values);

  /// Of the others of that value. Contract: at least one.
  double median_without(std::size_t value) const;

  /// Standard deviation of the others of that value. Contract: at least two.
  double deviation_without(std::size_t value) const;
  /// The same but for the one of them that is farthest from their median; of two as far away, that above it. Contract:
  /// at least three.
  double deviation_but_for_farthest(std::size_t value) const;

 private:
  double other(std::size_t rank, std::size_t left_out) const { return sorted_[rank < left_out ? rank : rank + 1]; }
  double median_of_others(std::size_t left_out) const;
  double deviation(std::size_t begin, std::size_t end, std::size_t left_out) const;

  std::vector<double> sorted_;
  std::vector<std::size_t> ranks_;  // ranks of the values as they were given
  // Sums of the differences from the middle one, and of their squares, of those between it and a rank: so summed, no
  // value far out takes digits from those nearer.
  std::vector<double> sums_, squares_;
};

}  // namespace axiometry::numeric
