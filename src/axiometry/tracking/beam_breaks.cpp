// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/beam_breaks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace axiometry::tracking {
namespace {

constexpr double least_mm = 0.02;        // smaller jumps are the machine's, or thermal
constexpr double scatters = 8.0;         // so many robust standard deviations no noise reaches
constexpr double incomparable_mm = 1.0;  // no reversal error is as large
constexpr double sd_per_mad = 1.4826;    // of normal noise
constexpr std::size_t votes_most = 100;

using Key = std::tuple<std::size_t, Direction, std::size_t, Direction>;  // from target, direction, to target, direction

double median(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::ranges::nth_element(x, middle);
  if (x.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(x.begin(), middle));
}

Direction other(Direction d) { return d == Direction::up ? Direction::down : Direction::up; }
double sign_of(Direction from, Direction to) { return from == to ? 0.0 : to == Direction::down ? 1.0 : -1.0; }

/// The steps between consecutive samples of one segment.
class Steps {
 public:
  Steps(std::span<const LineSample> samples, std::span<const Position> targets) : samples_(samples), targets_(targets) {
    for (std::size_t k = 0; k + 1 < samples.size(); ++k)
      if (exists(k)) by_key_[key(k)].push_back(k);
    std::vector<double> reversals;
    for (std::size_t k = 0; k + 1 < samples.size(); ++k)
      if (exists(k) && to(k).target == from(k).target && to(k).direction != from(k).direction)
        reversals.push_back(size(k) * sign_of(from(k).direction, to(k).direction));
    if (reversals.size() > 1) reversal_ = median(std::move(reversals));
    std::vector<double> slopes;
    for (std::size_t k = 0; k + 1 < samples.size(); ++k)
      if (const auto turned = reversal_part(k); exists(k) && turned && way(k) != 0.0)
        slopes.push_back((size(k) - *turned) / way(k));
    if (!slopes.empty()) slope_ = median(std::move(slopes));
  }

  bool exists(std::size_t k) const { return k + 1 < samples_.size() && from(k).segment == to(k).segment; }
  double size(std::size_t k) const { return to(k).excess_mm - from(k).excess_mm; }

  /// What is left of step k when the machine's own step is taken off; nothing when that is not known.
  std::optional<double> left(std::size_t k) const {
    const std::vector<double> votes = votes_on(k);
    if (votes.empty()) return std::nullopt;
    if (votes.size() >= 3) return size(k) - median(votes);
    double least = size(k) - votes.front();
    for (const double v : votes)
      if (std::abs(size(k) - v) < std::abs(least)) least = size(k) - v;
    return least;
  }

 private:
  const LineSample& from(std::size_t k) const { return samples_[k]; }
  const LineSample& to(std::size_t k) const { return samples_[k + 1]; }
  double way(std::size_t k) const { return targets_[to(k).target].in_native() - targets_[from(k).target].in_native(); }
  Key key(std::size_t k) const { return {from(k).target, from(k).direction, to(k).target, to(k).direction}; }

  std::optional<double> reversal_part(std::size_t k) const {
    const double sign = sign_of(from(k).direction, to(k).direction);
    if (sign == 0.0) return 0.0;
    if (!reversal_) return std::nullopt;
    return sign * *reversal_;
  }

  void collect(const Key& wanted, double sign, std::size_t but, std::vector<double>& votes) const {
    const auto found = by_key_.find(wanted);
    if (found == by_key_.end()) return;
    for (const std::size_t k : found->second)
      if (k != but && votes.size() < votes_most) votes.push_back(sign * size(k));
  }

  std::vector<double> votes_on(std::size_t k) const {
    const auto [i, a, j, b] = key(k);
    std::vector<double> votes;
    collect({i, a, j, b}, 1.0, k, votes);
    if (i != j || a != b) collect({j, b, i, a}, -1.0, k, votes);
    if (a == b && i != j) {
      collect({i, other(a), j, other(a)}, 1.0, k, votes);
      collect({j, other(a), i, other(a)}, -1.0, k, votes);
    }
    if (const auto turned = reversal_part(k); turned && (i == j || slope_))
      votes.push_back(slope_.value_or(0.0) * way(k) + *turned);
    return votes;
  }

  std::span<const LineSample> samples_;
  std::span<const Position> targets_;
  std::map<Key, std::vector<std::size_t>> by_key_;
  std::optional<double> reversal_;  // ↓ less ↑ at the turning points
  std::optional<double> slope_;     // mm of excess per mm of way
};

double threshold_of(const Steps& steps, std::size_t count) {
  std::vector<double> left;
  for (std::size_t k = 0; k + 1 < count; ++k)
    if (steps.exists(k))
      if (const auto x = steps.left(k)) left.push_back(std::abs(*x));
  return left.empty() ? least_mm : std::max(least_mm, scatters * sd_per_mad * median(std::move(left)));
}

}  // namespace

Jumps find_jumps(std::span<const LineSample> samples, std::span<const Position> targets,
                 std::optional<double> threshold_mm) {
  const Steps steps(samples, targets);
  Jumps jumps;
  jumps.threshold_mm = threshold_mm ? *threshold_mm : threshold_of(steps, samples.size());
  const auto jump = [&](std::size_t k) -> std::optional<double> {
    if (!steps.exists(k)) return std::nullopt;
    const auto left = steps.left(k);
    const double size = left.value_or(steps.size(k));
    const double limit = left ? jumps.threshold_mm : std::max(jumps.threshold_mm, incomparable_mm);
    return std::abs(size) > limit ? std::optional(size) : std::nullopt;
  };
  bool single = true;  // no step of the segment before this one, but what was told already
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    if (!steps.exists(k)) {
      single = true;
      continue;
    }
    const auto size = jump(k);
    const bool first = single;
    single = false;
    if (!size) continue;
    const auto next = jump(k + 1);
    if (next && std::abs(*size + *next) < 0.5 * std::max(std::abs(*size), std::abs(*next))) {
      jumps.outliers.push_back({k + 1, *size});
      ++k;
    } else if (first) {
      jumps.outliers.push_back({k, -*size});
    } else if (!steps.exists(k + 1)) {
      jumps.outliers.push_back({k + 1, *size});
    } else {
      jumps.breaks.push_back({k + 1, *size});
    }
  }
  return jumps;
}

}  // namespace axiometry::tracking
