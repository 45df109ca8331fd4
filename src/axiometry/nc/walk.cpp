// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/walk.h"

#include <algorithm>
#include <array>
#include <span>

namespace axiometry::nc {
namespace {

using Moves = std::span<const PlannedMove>;

bool same_but_run(const PlannedMove& a, const PlannedMove& b) {
  if (a.to != b.to || a.approach.has_value() != b.approach.has_value()) return false;
  return !a.approach || (a.approach->target == b.approach->target && a.approach->direction == b.approach->direction);
}

struct Repetition {
  std::size_t period = 1;
  std::size_t times = 1;
  std::size_t size() const { return period * times; }
};

/// Looks for repetitions from front to back, each move once for each period.
class Search {
 public:
  Search(Moves list, std::span<const std::size_t> periods) : list_(list) {
    for (std::size_t period : periods) periods_.push_back({period, 0});
  }

  /// The repetition at `begin` that covers most moves. `begin` never goes back.
  Repetition at(std::size_t begin) {
    Repetition best;
    for (auto& [period, alike_to] : periods_) {
      alike_to = std::max(alike_to, begin);
      while (alike_to + period < list_.size() && same_but_run(list_[alike_to], list_[alike_to + period])) ++alike_to;
      const Repetition found{period, 1 + (alike_to - begin) / period};
      if (found.times > 1 && found.size() > best.size()) best = found;
    }
    return best;
  }

 private:
  struct Period {
    std::size_t moves = 1;
    std::size_t alike_to = 0;  ///< the first move that is not as the one a period later, as far as is known
  };

  Moves list_;
  std::vector<Period> periods_;
};

std::size_t last_run(Moves list) {
  for (std::size_t k = list.size(); k-- > 0;)
    if (list[k].approach) return list[k].approach->run;
  return 0;
}

RepeatedMoves stretch(Moves list, Repetition repetition) {
  const Moves once = list.first(repetition.period);
  return {.times = repetition.times,
          .moves = {once.begin(), once.end()},
          .last_run = last_run(list.first(repetition.size()))};
}

}  // namespace

std::vector<RepeatedMoves> walk(const Plan& plan, std::size_t loop_limit) {
  const std::vector<PlannedMove> all = moves(plan);
  const std::size_t m = plan.targets.size();
  // There and back (warm-up, one target from one direction), one target from both, one pass, two passes.
  const std::array<std::size_t, 4> periods = {2, 4, m + 1, 2 * m + 2};
  Search search(all, periods);
  std::vector<RepeatedMoves> list = {stretch(Moves(all).first(1), {})};
  std::size_t loops = 0;
  bool plain = false;  // whether the last stretch takes further single moves
  for (Moves rest = Moves(all).subspan(1); !rest.empty();) {
    const Repetition found = loops < loop_limit ? search.at(all.size() - rest.size()) : Repetition{};
    if (found.times > 1) {
      list.push_back(stretch(rest, found));
      ++loops;
    } else if (plain) {
      list.back().moves.push_back(rest.front());
      if (rest.front().approach) list.back().last_run = rest.front().approach->run;
    } else {
      list.push_back(stretch(rest, {}));
    }
    plain = found.times == 1;
    rest = rest.subspan(found.size());
  }
  return list;
}

}  // namespace axiometry::nc
