// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/travel.h"

#include <algorithm>
#include <utility>

namespace axiometry::capture {
namespace {

constexpr std::size_t most_turns = 20'000;

double median_of_three(double a, double b, double c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

}  // namespace

void Travel::move_to(double position) {
  befores_ = 0;
  go_to(position);
}

void Travel::go_to(double position) {
  if (!anywhere_) {
    anywhere_ = true;
    turn_low_ = turn_high_ = lowest_ = highest_ = position;
    return;
  }
  lowest_ = std::min(lowest_, position);
  highest_ = std::max(highest_, position);
  const bool came_down = turn_high_ - position > turn_ && direction_ != Direction::down;
  const bool came_up = position - turn_low_ > turn_ && direction_ != Direction::up;
  if ((came_down || came_up) && turns_.size() < most_turns) turns_.push_back(came_down ? turn_high_ : turn_low_);
  if (came_down) {
    direction_ = Direction::down;
    turn_low_ = turn_high_ = position;
  } else if (came_up) {
    direction_ = Direction::up;
    turn_low_ = turn_high_ = position;
  }
  turn_low_ = std::min(turn_low_, position);
  turn_high_ = std::max(turn_high_, position);
  // Going up, only a fall from the highest place counts, and the other way round.
  if (direction_ == Direction::up) turn_low_ = turn_high_;
  if (direction_ == Direction::down) turn_high_ = turn_low_;
}

void Travel::move_along(std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    if (befores_ == 2) go_to(median_of_three(before_[0], before_[1], sample.position));
    before_[0] = std::exchange(before_[1], sample.position);
    befores_ = std::min<std::size_t>(befores_ + 1, 2);
  }
}

std::vector<double> Travel::take_turns() { return std::exchange(turns_, {}); }

double Travel::beyond(double position) const {
  if (!direction_) return 0.0;
  return std::max(0.0, direction_ == Direction::up ? turn_high_ - position : position - turn_low_);
}

void Travel::forget() {
  direction_.reset();
  anywhere_ = false;
  befores_ = 0;
}

}  // namespace axiometry::capture
