// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/dead_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "axiometry/numeric/dense/dense.h"

namespace axiometry::tracking {
namespace {

enum class By { approach, target };

std::size_t group_of(const TiedSample& s, By by) {
  return by == By::target ? s.target : 2 * s.target + static_cast<std::size_t>(s.direction);
}

/// Sets of stretches that samples of the same group join.
class Parts {
 public:
  Parts(std::span<const TiedSample> samples, std::size_t stretches, By by) : part_(stretches) {
    std::iota(part_.begin(), part_.end(), std::size_t{0});
    std::map<std::size_t, std::size_t> first;
    for (const TiedSample& s : samples)
      if (s.used) join(first.emplace(group_of(s, by), s.stretch).first->second, s.stretch);
    for (std::size_t& p : part_) p = root(p);
  }
  std::size_t operator[](std::size_t stretch) const { return part_[stretch]; }
  std::size_t count() const {
    std::size_t roots = 0;
    for (std::size_t k = 0; k < part_.size(); ++k) roots += part_[k] == k ? 1 : 0;
    return roots;
  }

 private:
  std::size_t root(std::size_t k) const {
    while (part_[k] != k) k = part_[k];
    return k;
  }
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    part_[std::max(a, b)] = std::min(a, b);  // so that a root is the first of its part
  }
  std::vector<std::size_t> part_;
};

struct Solution {
  DeadPathFit fit;
  bool unique = true;
};

/// Least squares for the shifts of all stretches but the first of each part, and by target for the reversal error too;
/// the deviations of the groups are eliminated by taking the mean of each group off.
Solution solve(std::span<const TiedSample> samples, std::size_t stretches, By by) {
  const Parts parts(samples, stretches, by);
  std::vector<Eigen::Index> column(stretches, -1);
  Eigen::Index columns = 0;
  for (std::size_t k = 0; k < stretches; ++k)
    if (parts[k] != k) column[k] = columns++;
  const Eigen::Index reversal = by == By::target ? columns++ : -1;
  std::map<std::size_t, std::vector<std::size_t>> groups;
  std::size_t used = 0;
  for (std::size_t k = 0; k < samples.size(); ++k)
    if (samples[k].used) groups[group_of(samples[k], by)].push_back(k), ++used;

  Solution solution{{std::vector<StretchFit>(stretches), by == By::approach, 0.0, 0}, true};
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(columns);
  double squares = 0.0;
  for (const auto& [group, members] : groups) {
    const auto n = static_cast<Eigen::Index>(members.size());
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n, columns);
    Eigen::VectorXd excess(n);
    for (Eigen::Index r = 0; r < n; ++r) {
      const TiedSample& s = samples[members[static_cast<std::size_t>(r)]];
      if (column[s.stretch] >= 0) rows(r, column[s.stretch]) = 1.0;
      if (reversal >= 0 && s.direction == Direction::down) rows(r, reversal) = s.cosine;
      excess(r) = s.excess_mm;
    }
    rows.rowwise() -= rows.colwise().mean().eval();
    excess.array() -= excess.mean();
    normal += rows.transpose() * rows;
    right += rows.transpose() * excess;
    squares += excess.squaredNorm();
    const bool shared = std::ranges::any_of(
        members, [&](std::size_t k) { return samples[k].stretch != samples[members.front()].stretch; });
    if (shared)
      for (const std::size_t k : members) ++solution.fit.stretches[samples[k].stretch].ties;
  }
  for (std::size_t k = 0; k < stretches; ++k) solution.fit.stretches[k].tied = parts[k] == 0;
  if (columns == 0) return solution;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> values(normal, Eigen::EigenvaluesOnly);
  // Entries are counts of readings: below this an eigenvalue is rounding, not a weak tie.
  solution.unique = values.eigenvalues()(0) > 1e-9 * std::max(1.0, values.eigenvalues()(columns - 1));
  if (!solution.unique) return solution;
  const Eigen::LDLT<Eigen::MatrixXd> factors(normal);
  const Eigen::VectorXd x = factors.solve(right);
  const auto taken = groups.size() + static_cast<std::size_t>(columns);
  solution.fit.degrees_of_freedom = used > taken ? used - taken : 0;
  if (solution.fit.degrees_of_freedom > 0)
    solution.fit.scatter_mm =
        std::sqrt(std::max(0.0, squares - x.dot(right)) / static_cast<double>(solution.fit.degrees_of_freedom));
  const Eigen::MatrixXd inverse = factors.solve(Eigen::MatrixXd::Identity(columns, columns));
  for (std::size_t k = 0; k < stretches; ++k) {
    if (column[k] < 0) continue;
    StretchFit& stretch = solution.fit.stretches[k];
    stretch.shift_mm = x(column[k]);
    stretch.uncertainty_mm = solution.fit.scatter_mm * std::sqrt(inverse(column[k], column[k]));
  }
  return solution;
}

/// Mean of what a part of the stretches leaves at a target, their shifts taken off.
struct Level {
  double sum = 0.0;
  double count = 0.0;
};

/// Shifts every part that nothing ties to the first so that the mean deviation does not jump between the two targets
/// that are nearest to each other.
void join_parts(std::span<const TiedSample> samples, std::span<const Position> targets, const Parts& parts,
                DeadPathFit& fit) {
  std::map<std::size_t, std::map<std::size_t, Level>> levels;  // levels of each part at each target
  std::set<std::size_t> with_used;
  for (const TiedSample& s : samples)
    if (s.used) with_used.insert(parts[s.stretch]);
  for (const TiedSample& s : samples) {
    if (!s.used && with_used.contains(parts[s.stretch])) continue;  // an outlier tells no level where others do
    Level& level = levels[parts[s.stretch]][s.target];
    level.sum += s.excess_mm - fit.stretches[s.stretch].shift_mm;
    level.count += 1.0;
  }
  std::map<std::size_t, Level> joined = levels[0];
  levels.erase(0);
  while (!levels.empty()) {
    double nearest = std::numeric_limits<double>::infinity(), step = 0.0;
    std::size_t next = levels.begin()->first;
    for (const auto& [part, own] : levels)
      for (const auto& [i, a] : own)
        for (const auto& [j, b] : joined)
          if (const double apart = std::abs(targets[i].in_native() - targets[j].in_native()); apart < nearest) {
            nearest = apart;
            step = a.sum / a.count - b.sum / b.count;
            next = part;
          }
    for (std::size_t k = 0; k < fit.stretches.size(); ++k)
      if (parts[k] == next) fit.stretches[k].shift_mm += step;
    for (const auto& [i, a] : levels[next]) {
      joined[i].sum += a.sum - step * a.count;
      joined[i].count += a.count;
    }
    levels.erase(next);
  }
}

}  // namespace

DeadPathFit fit_dead_paths(std::span<const TiedSample> samples, std::span<const Position> targets,
                           std::size_t stretches) {
  const Parts by_approach(samples, stretches, By::approach);
  Solution solution = solve(samples, stretches, By::approach);
  if (by_approach.count() == 1) return solution.fit;
  const Parts by_target(samples, stretches, By::target);
  if (by_target.count() < by_approach.count()) {
    Solution further = solve(samples, stretches, By::target);
    if (further.unique) {
      if (by_target.count() > 1) join_parts(samples, targets, by_target, further.fit);
      return further.fit;
    }
  }
  join_parts(samples, targets, by_approach, solution.fit);
  return solution.fit;
}

}  // namespace axiometry::tracking
