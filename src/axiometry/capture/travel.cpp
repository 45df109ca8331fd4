// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/travel.h"

#include <algorithm>

namespace axiometry::capture {
namespace {

double median_of_three(double a, double b, double c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

}  // namespace

void Travel::move_to(double position) {
  if (!anywhere_) {
    anywhere_ = true;
    turn_low_ = turn_high_ = lowest_ = highest_ = position;
    return;
  }
  lowest_ = std::min(lowest_, position);
  highest_ = std::max(highest_, position);
  const bool came_down = turn_high_ - position > turn_ && direction_ != Direction::down;
  const bool came_up = position - turn_low_ > turn_ && direction_ != Direction::up;
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
  if (samples.size() < 3) return;
  for (std::size_t k = 1; k + 1 < samples.size(); ++k)
    move_to(median_of_three(samples[k - 1].position, samples[k].position, samples[k + 1].position));
}

void Travel::forget() {
  direction_.reset();
  anywhere_ = false;
}

}  // namespace axiometry::capture
