// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/beam_breaks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "axiometry/numeric/median.h"

namespace axiometry::tracking {
namespace {

constexpr double least_mm = 0.02;        // smaller jumps are the machine's, or thermal
constexpr double weak_least_mm = 0.05;   // where only the mean slope of the machine is known
constexpr double incomparable_mm = 1.0;  // neither a reversal error nor a single bad reading is as large
constexpr double scatters = 8.0;         // so many robust standard deviations no noise reaches
constexpr double sd_per_mad = 1.4826;    // σ of normal noise over its median absolute deviation
constexpr std::size_t votes_most = 100;
constexpr std::size_t jumps_most = 1000;

/// A step: target and direction before it, target and direction behind it.
using Key = std::tuple<std::size_t, Direction, std::size_t, Direction>;

Direction other(Direction d) { return d == Direction::up ? Direction::down : Direction::up; }

/// What is left of a step when the machine's own is taken off.
struct Left {
  double size_mm = 0.0;
  enum class By { other_runs, mean_slope, nothing } by = By::nothing;
};

/// The steps between consecutive samples of one segment. Those found to be jumps have no vote on the others.
class Steps {
 public:
  Steps(std::span<const LineSample> samples, std::span<const Position> targets)
      : samples_(samples), targets_(targets), jumped_(samples.size(), false) {
    for (std::size_t k = 0; k + 1 < samples.size(); ++k)
      if (exists(k)) by_key_[key(k)].push_back(k);
    learn();
  }

  std::size_t count() const { return samples_.empty() ? 0 : samples_.size() - 1; }
  bool exists(std::size_t k) const { return k + 1 < samples_.size() && from(k).segment == to(k).segment; }
  bool jumped(std::size_t k) const { return jumped_[k]; }

  void mark(std::size_t k) {
    jumped_[k] = true;
    learn();
  }

  /// By the other runs and the other direction, where two or more say what the machine does there; by one of them or
  /// the machine's mean, whichever comes nearer; or as it is, when nothing is known.
  Left left(std::size_t k) const {
    std::vector<double> votes = direct_votes(k);
    const bool many = votes.size() >= 2;
    for (const double v : derived_votes(k)) votes.push_back(v);
    if (votes.empty()) return {size(k), Left::By::nothing};
    if (many) return {size(k) - numeric::median(std::move(votes)), Left::By::other_runs};
    double least = size(k) - votes.front();
    for (const double v : votes)
      if (std::abs(size(k) - v) < std::abs(least)) least = size(k) - v;
    return {least, Left::By::mean_slope};
  }

 private:
  const LineSample& from(std::size_t k) const { return samples_[k]; }
  const LineSample& to(std::size_t k) const { return samples_[k + 1]; }
  double size(std::size_t k) const { return to(k).excess_mm - from(k).excess_mm; }
  double way(std::size_t k) const { return targets_[to(k).target].in_native() - targets_[from(k).target].in_native(); }
  Key key(std::size_t k) const { return {from(k).target, from(k).direction, to(k).target, to(k).direction}; }

  /// Steps of this key that are no jumps, times `sign`.
  void collect(const Key& wanted, double sign, std::size_t but, std::vector<double>& votes) const {
    const auto found = by_key_.find(wanted);
    if (found == by_key_.end()) return;
    for (const std::size_t k : found->second)
      if (k != but && !jumped_[k] && votes.size() < votes_most) votes.push_back(sign * size(k));
  }

  /// The same two approaches in other runs, either way round, and the same targets in the other direction.
  std::vector<double> direct_votes(std::size_t k) const {
    const auto [i, a, j, b] = key(k);
    std::vector<double> votes;
    collect({i, a, j, b}, 1.0, k, votes);
    if (i != j || a != b) collect({j, b, i, a}, -1.0, k, votes);
    if (a == b && i != j) {
      collect({i, other(a), j, other(a)}, 1.0, k, votes);
      collect({j, other(a), i, other(a)}, -1.0, k, votes);
    }
    return votes;
  }

  /// From a to b in the same direction, over the targets in between where they are known.
  std::optional<double> along(std::size_t a, std::size_t b, Direction d) const {
    const std::size_t low = std::min(a, b), high = std::max(a, b);
    double sum = 0.0;
    for (std::size_t i = low; i < high; ++i) {
      std::vector<double> steps;
      collect({i, d, i + 1, d}, 1.0, samples_.size(), steps);
      collect({i + 1, d, i, d}, -1.0, samples_.size(), steps);
      if (steps.empty()) return std::nullopt;
      sum += numeric::median(std::move(steps));
    }
    return a < b ? sum : -sum;
  }

  /// ↓ less ↑ at a target, or in the mean of all.
  std::optional<double> reversal_at(std::size_t target, std::size_t but) const {
    std::vector<double> sizes;
    collect({target, Direction::up, target, Direction::down}, 1.0, but, sizes);
    collect({target, Direction::down, target, Direction::up}, -1.0, but, sizes);
    return sizes.empty() ? reversal_ : std::optional(numeric::median(std::move(sizes)));
  }

  /// The machine's mean slope and reversal error; over several targets the sum of their steps.
  std::vector<double> derived_votes(std::size_t k) const {
    const auto [i, a, j, b] = key(k);
    std::vector<double> votes;
    if (i + 1 < j || j + 1 < i)
      if (const auto sum = along(i, j, a); sum && a == b) votes.push_back(*sum);
    const double sign = a == b ? 0.0 : b == Direction::down ? 1.0 : -1.0;
    if (i != j && !slope_) return votes;
    const double sloped = i == j ? 0.0 : *slope_ * way(k);
    if (a == b) {
      votes.push_back(sloped);
      return votes;
    }
    for (const std::size_t target : {i, j})
      if (const auto turned = reversal_at(target, k); turned && (i != j || reversals_ > 1))
        votes.push_back(sloped + sign * *turned);
    return votes;
  }

  void learn() {
    std::vector<double> turned, slopes;
    for (std::size_t k = 0; k < count(); ++k)
      if (exists(k) && !jumped_[k] && to(k).target == from(k).target && to(k).direction != from(k).direction)
        turned.push_back(to(k).direction == Direction::down ? size(k) : -size(k));
    reversals_ = turned.size();
    reversal_ = turned.empty() ? std::nullopt : std::optional(numeric::median(std::move(turned)));
    for (std::size_t k = 0; k < count(); ++k) {
      if (!exists(k) || jumped_[k] || way(k) == 0.0) continue;
      const bool alike = to(k).direction == from(k).direction;
      if (!alike && !reversal_) continue;
      const double sign = alike ? 0.0 : to(k).direction == Direction::down ? 1.0 : -1.0;
      slopes.push_back((size(k) - sign * reversal_.value_or(0.0)) / way(k));
    }
    slope_ = slopes.empty() ? std::nullopt : std::optional(numeric::median(std::move(slopes)));
  }

  std::span<const LineSample> samples_;
  std::span<const Position> targets_;
  std::vector<bool> jumped_;
  std::map<Key, std::vector<std::size_t>> by_key_;
  std::size_t reversals_ = 0;       // turning points that were no jumps
  std::optional<double> reversal_;  // mean of ↓ less ↑ over all turning points
  std::optional<double> slope_;     // mm of excess per mm of way
};

struct Thresholds {
  double strong_mm = least_mm;
  double weak_mm = weak_least_mm;

  double of(Left::By by) const {
    if (by == Left::By::nothing) return std::max(strong_mm, incomparable_mm);
    return by == Left::By::other_runs ? strong_mm : weak_mm;
  }
};

double limit_from(std::vector<double> left, double least) {
  return left.empty() ? least : std::max(least, scatters * sd_per_mad * numeric::median(std::move(left)));
}

Thresholds thresholds(const Steps& steps, std::optional<double> given_mm) {
  if (given_mm) return {*given_mm, *given_mm};
  std::vector<double> strong, all;
  for (std::size_t k = 0; k < steps.count(); ++k) {
    if (!steps.exists(k)) continue;
    const Left left = steps.left(k);
    if (left.by == Left::By::other_runs) strong.push_back(std::abs(left.size_mm));
    if (left.by != Left::By::nothing) all.push_back(std::abs(left.size_mm));
  }
  return {limit_from(std::move(strong), least_mm), limit_from(std::move(all), weak_least_mm)};
}

/// What is left of a step that is a jump, and from what size on it is one.
struct FoundJump {
  double size_mm = 0.0;  // 0: no jump
  double limit_mm = 0.0;
};

/// Whether the second takes back the first.
bool cancels(const FoundJump& a, const FoundJump& b) {
  const double left = std::abs(a.size_mm + b.size_mm);
  return b.size_mm != 0.0 && left < 0.5 * std::max(std::abs(a.size_mm), std::abs(b.size_mm)) &&
         left <= std::max(a.limit_mm, b.limit_mm);
}

/// The largest first, so that what it does to the votes on others is gone before they are judged.
std::vector<FoundJump> jumps_of(Steps& steps, const Thresholds& limits) {
  for (std::size_t found = 0; found < jumps_most; ++found) {
    std::optional<std::size_t> largest;
    double excess = 1.0;
    for (std::size_t k = 0; k < steps.count(); ++k) {
      if (!steps.exists(k) || steps.jumped(k)) continue;
      const Left left = steps.left(k);
      if (const double x = std::abs(left.size_mm) / limits.of(left.by); x > excess) {
        excess = x;
        largest = k;
      }
    }
    if (!largest) break;
    steps.mark(*largest);
  }
  std::vector<FoundJump> jumps(steps.count());  // judged again by limits that no jump takes part in
  for (std::size_t k = 0; k < steps.count(); ++k) {
    if (!steps.jumped(k)) continue;
    const Left left = steps.left(k);
    if (const double limit = limits.of(left.by); std::abs(left.size_mm) > limit) jumps[k] = {left.size_mm, limit};
  }
  return jumps;
}

}  // namespace

Jumps find_jumps(std::span<const LineSample> samples, std::span<const Position> targets,
                 std::optional<double> threshold_mm) {
  Steps steps(samples, targets);
  const Thresholds limits = thresholds(steps, threshold_mm);
  Jumps jumps;
  jumps.threshold_mm = limits.strong_mm;
  const std::vector<FoundJump> found = jumps_of(steps, limits);
  bool first = true;  // whether a jump is the first of its segment
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool single = first;
    first = !steps.exists(k);
    const double size = found[k].size_mm;
    if (size == 0.0) continue;
    if (k + 1 < found.size() && cancels(found[k], found[k + 1])) {
      jumps.outliers.push_back({k + 1, size});
      ++k;
    } else if (std::abs(size) > incomparable_mm || (!single && steps.exists(k + 1))) {
      jumps.breaks.push_back({k + 1, size});
    } else if (single) {
      jumps.outliers.push_back({k, -size});
    } else {
      jumps.outliers.push_back({k + 1, size});
    }
  }
  return jumps;
}

}  // namespace axiometry::tracking
