// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/walk.h"

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

/// The repetition at the beginning of `list` that covers most moves.
Repetition repetition_at(Moves list, std::span<const std::size_t> periods) {
  Repetition best;
  for (std::size_t period : periods) {
    std::size_t alike = 0;
    while (alike + period < list.size() && same_but_run(list[alike], list[alike + period])) ++alike;
    const Repetition found{period, 1 + alike / period};
    if (found.times > 1 && found.size() > best.size()) best = found;
  }
  return best;
}

std::size_t last_run(Moves list) {
  for (std::size_t k = list.size(); k-- > 0;)
    if (list[k].approach) return list[k].approach->run;
  return 0;
}

Stretch stretch(Moves list, Repetition repetition) {
  const Moves once = list.first(repetition.period);
  return {.times = repetition.times,
          .moves = {once.begin(), once.end()},
          .last_run = last_run(list.first(repetition.size()))};
}

}  // namespace

std::vector<Stretch> walk(const Plan& plan, std::size_t loop_limit) {
  const std::vector<PlannedMove> all = moves(plan);
  const std::size_t m = plan.targets.size();
  // There and back (warm-up, one target from one direction), one target from both, one pass, two passes.
  const std::array<std::size_t, 4> periods = {2, 4, m + 1, 2 * m + 2};
  Moves rest = all;
  std::vector<Stretch> list = {stretch(rest.first(1), {})};
  rest = rest.subspan(1);
  std::size_t loops = 0;
  bool plain = false;  // whether the last stretch takes further single moves
  while (!rest.empty()) {
    const Repetition found = loops < loop_limit ? repetition_at(rest, periods) : Repetition{};
    if (found.times > 1) {
      list.push_back(stretch(rest, found));
      ++loops;
    } else if (plain) {
      list.back().moves.push_back(rest.front());
      list.back().last_run = last_run(list.back().moves);
    } else {
      list.push_back(stretch(rest, {}));
    }
    plain = found.times == 1;
    rest = rest.subspan(found.size());
  }
  return list;
}

}  // namespace axiometry::nc
