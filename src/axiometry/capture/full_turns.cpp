// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/full_turns.h"

#include <algorithm>
#include <cmath>

namespace axiometry::capture {
namespace {

constexpr double half_turn_deg = full_turn_deg / 2.0;
constexpr double slowest_limit_deg_per_s = 500.0;
constexpr double feeds_at_most = 2.0;        // an override of a control allows no more
constexpr double unsteady_deg = 0.5;         // noise of samples, at any rate
constexpr std::size_t samples_in_a_row = 3;  // two false ones in a row are possible

}  // namespace

double fastest_turn(double feed_deg_per_min) {
  return std::max(slowest_limit_deg_per_s, feeds_at_most * feed_deg_per_min / 60.0);
}

/// How far the axis can be from the last sample. Samples of one time came in one burst: they lie as far apart as
/// others.
double FullTurns::reach_deg(const Sample& shown) const {
  const double time_s = shown.time_s > last_->time_s ? shown.time_s - last_->time_s : step_s_;
  return unsteady_deg + fastest_deg_per_s_ * time_s;
}

/// An instrument that rolls over shows no more than one turn: what does not fit what it shows now was false.
void FullTurns::see(double shown_deg) {
  lowest_deg_ = std::min(lowest_deg_, shown_deg);
  highest_deg_ = std::max(highest_deg_, shown_deg);
  if (highest_deg_ - lowest_deg_ > full_turn_deg + unsteady_deg) lowest_deg_ = highest_deg_ = shown_deg;
}

void FullTurns::take(const Sample& shown) {
  if (!last_) {
    last_ = shown;
    lowest_deg_ = highest_deg_ = shown.position;
    return;
  }
  const double reach = reach_deg(shown);
  const double next = std::round((last_->position - shown.position) / full_turn_deg);
  const bool in_reach = std::abs(shown.position + full_turn_deg * next - last_->position) <= reach;
  doubtful_ = in_reach ? 0 : doubtful_ + 1;
  const bool believed = doubtful_ == 0 || doubtful_ >= samples_in_a_row;
  const bool rolls_over = in_reach && reach <= half_turn_deg && std::abs(next - turns_) == 1.0;
  if (next != turns_ && (rolls_over || (rolls_from_s_ && believed))) turns_ = next;
  if (!rolls_from_s_) {
    rolled_ = turns_ == 0.0 ? 0 : rolled_ + 1;
    if (rolled_ == 1) rolled_at_s_ = shown.time_s;
    if (rolled_ >= samples_in_a_row) rolls_from_s_ = rolled_at_s_;
  }
  if (shown.time_s > last_->time_s) step_s_ = shown.time_s - last_->time_s;
  if (!believed) return;
  doubtful_ = 0;
  see(shown.position);
  last_ = {shown.time_s, shown.position + full_turn_deg * turns_};
}

double FullTurns::shown_deg(double position_deg) const {
  if (turns_ == 0.0 && !rolls_from_s_) return position_deg;
  const double middle = 0.5 * (lowest_deg_ + highest_deg_);
  return position_deg - full_turn_deg * std::round((position_deg - middle) / full_turn_deg);
}

std::span<const Sample> FullTurns::follow(std::span<const Sample> shown) {
  counted_on_.clear();
  for (std::size_t k = 0; k < shown.size(); ++k) {
    take(shown[k]);
    if (turns_ != 0.0 && counted_on_.empty()) counted_on_.assign(shown.begin(), shown.begin() + k);
    if (turns_ != 0.0 || !counted_on_.empty())
      counted_on_.push_back({shown[k].time_s, shown[k].position + full_turn_deg * turns_});
  }
  return counted_on_.empty() ? shown : std::span<const Sample>(counted_on_);
}

}  // namespace axiometry::capture
