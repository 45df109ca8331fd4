// SPDX-License-Identifier: Apache-2.0
#include "server/http/fair_queue.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "server/log.h"

namespace axiometry::server {
namespace {

void run_step(const FairQueue::Step& step) {
  try {
    step();
  } catch (const std::exception& exception) {
    log_failure("a connection", exception);
  }
}

}  // namespace

/// The turn first: one that finds nobody does no harm.
void FairQueue::enter(const std::string& peer, Step step) {
  turn();
  const auto line = std::ranges::find(lines_, peer, &Line::peer);
  if (line != lines_.end()) return line->steps.push_back(std::move(step));
  std::list<Line> fresh(1);
  fresh.front().peer = peer;
  fresh.front().steps.push_back(std::move(step));
  lines_.splice(lines_.end(), fresh);
}

void FairQueue::turn() {
  if (is_turning_) return;
  post_([this] { let_in(); });
  is_turning_ = true;
}

FairQueue::Step FairQueue::first_in_turn() {
  const auto line = lines_.begin();
  Step step = std::move(line->steps.front());
  line->steps.pop_front();
  if (line->steps.empty())
    lines_.erase(line);
  else
    lines_.splice(lines_.end(), lines_, line);
  return step;
}

/// What the step begins stands before the next step. Where the next turn cannot be posted it is taken at once.
void FairQueue::let_in() {
  is_turning_ = false;
  while (!lines_.empty()) {
    run_step(first_in_turn());
    if (lines_.empty()) return;
    try {
      return turn();
    } catch (const std::exception& exception) {
      log_failure("a turn", exception);
    }
  }
}

}  // namespace axiometry::server
