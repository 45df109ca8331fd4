// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/leave_one_out.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {

LeaveOneOut::LeaveOneOut(std::vector<double> values)
    : ranks_(values.size()), sums_(values.size() + 1, 0.0), squares_(values.size() + 1, 0.0) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return values[k]; });
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    ranks_[order[rank]] = rank;
    sorted_.push_back(values[order[rank]]);
  }
  const std::size_t middle = sorted_.size() / 2;
  const auto difference = [&](std::size_t rank) { return sorted_[rank] - sorted_[middle]; };
  for (std::size_t k = middle; k < sorted_.size(); ++k) {
    sums_[k + 1] = sums_[k] + difference(k);
    squares_[k + 1] = squares_[k] + difference(k) * difference(k);
  }
  for (std::size_t k = middle; k-- > 0;) {
    sums_[k] = sums_[k + 1] + difference(k);
    squares_[k] = squares_[k + 1] + difference(k) * difference(k);
  }
}

double LeaveOneOut::median_of_others(std::size_t left_out) const {
  const std::size_t count = sorted_.size() - 1;
  const double upper = other(count / 2, left_out);
  return count % 2 == 1 ? upper : 0.5 * (upper + other(count / 2 - 1, left_out));
}

double LeaveOneOut::median_without(std::size_t value) const {
  AXIOMETRY_CONTRACT(sorted_.size() >= 2);
  return median_of_others(ranks_[value]);
}

/// Of those of rank begin to end, the one left out not among them.
double LeaveOneOut::deviation(std::size_t begin, std::size_t end, std::size_t left_out) const {
  if (left_out == begin) ++begin;
  if (left_out + 1 == end) --end;
  const bool within = begin < left_out && left_out < end;
  const auto count = double(end - begin - (within ? 1 : 0));
  // Of two the middle one may be far away; of more it is one of them, or lies between them.
  if (count == 2.0) return (sorted_[end - 1] - sorted_[begin]) / std::numbers::sqrt2;
  double sum = sums_[begin] + sums_[end];
  double squares = squares_[begin] + squares_[end];
  if (within) {
    const double own = sorted_[left_out] - sorted_[sorted_.size() / 2];
    sum -= own;
    squares -= own * own;
  }
  return std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1.0));
}

double LeaveOneOut::deviation_without(std::size_t value) const {
  AXIOMETRY_CONTRACT(sorted_.size() >= 3);
  return deviation(0, sorted_.size(), ranks_[value]);
}

double LeaveOneOut::deviation_but_for_farthest(std::size_t value) const {
  AXIOMETRY_CONTRACT(sorted_.size() >= 4);
  const std::size_t left_out = ranks_[value], last = sorted_.size() - 2;
  const double median = median_of_others(left_out);
  const bool lowest = median - other(0, left_out) > other(last, left_out) - median;
  // The others from one end to the other, without the value that is farthest.
  const std::size_t begin = lowest ? (left_out == 0 ? 2 : 1) : 0;
  const std::size_t end = sorted_.size() - (lowest ? 0 : (left_out == sorted_.size() - 1 ? 2 : 1));
  return deviation(begin, end, left_out);
}

}  // namespace axiometry::numeric
