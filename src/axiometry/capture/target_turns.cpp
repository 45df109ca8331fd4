// SPDX-License-Identifier: Apache-2.0
//
// Which turn of the plan a rotary axis is in.
#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/capture/full_turns.h"
#include "axiometry/capture/target_matcher.h"

namespace axiometry::capture {

bool TargetMatcher::rolls(const Standstill& s) const { return rolls_from_s_ && s.used_to_s >= *rolls_from_s_; }

/// Which turn of the plan the axis is in. A person may have turned it before the test, and behind missing samples
/// nobody counted; else what the instrument shows counts on, but for a motion too fast to be followed. Of an instrument
/// that was not seen to roll over what it shows is believed, unless nothing but whole turns are between that and what
/// is due.
void TargetMatcher::find_turn(const Standstill& s) {
  if (walk_->plan.axis.kind == AxisKind::linear || !s.arrival || s.frozen_from_s) return;
  if (rolls(s)) tell_rollover(s);
  const bool fits = target_at(shifted(s, turns_deg_).position).has_value();
  if (turn_found_ && (fits || !rolls(s) || !last_)) return;
  const Approach& due = walk_->approaches[due_];
  const auto is_due = [&](double turns_deg) {
    return due.direction == *s.arrival && target_at(shifted(s, turns_deg).position) == due.target;
  };
  const bool known_before = fits && last_ && !rolls(s);
  const auto found = known_before ? std::nullopt : turns_to_target(s);
  const double turns_deg = found && (is_due(*found) || (rolls(s) && !turn_found_)) ? *found : turns_deg_;
  const auto target = target_at(shifted(s, turns_deg).position);
  if (!target || (*target != due.target && !approach_for(*target, s))) return;
  if (turns_deg != turns_deg_) lowest_ = highest_ = shifted(s, turns_deg).position.in_native();
  turn_found_ = true;
  turns_deg_ = turns_deg;
}

/// The whole turns that put the standstill at a target: at the one of the earliest approach that it can be, or next to
/// the one that is due.
std::optional<double> TargetMatcher::turns_to_target(const Standstill& s) const {
  const double due = walk_->plan.targets[walk_->approaches[due_].target].in_native();
  const double x = s.position.in_native(), window = window_.in_native();
  constexpr double most_deg = 1e9;  // farther a whole turn more is no other number before long
  if (!(std::abs(x) <= most_deg)) return std::nullopt;
  const double last = std::floor((walk_->plan.targets.back().in_native() + window - x) / full_turn_deg);
  std::optional<double> best;
  std::pair<std::size_t, double> best_rank;
  for (double n = std::ceil((walk_->plan.targets.front().in_native() - window - x) / full_turn_deg); n <= last;
       n += 1.0) {
    const double there = x + full_turn_deg * n;
    const auto target = target_at(Position::native(there));
    if (!target) continue;
    const auto placed = approach_for(*target, s);
    const std::pair rank{placed ? placed->approach : walk_->approaches.size(), std::abs(there - due)};
    if (best && rank >= best_rank) continue;
    best = full_turn_deg * n;
    best_rank = rank;
  }
  return best;
}

/// Before the turn is known.
bool TargetMatcher::at_overrun_of_a_turn(const Standstill& s) const {
  if (turn_found_ || !rolls(s)) return false;
  return std::ranges::any_of(walk_->turning_points, [&](Position point) {
    return std::abs(std::remainder(s.position.in_native() - point.in_native(), full_turn_deg)) <= window_.in_native();
  });
}

void TargetMatcher::tell_rollover(const Standstill& s) {
  if (std::exchange(rollover_told_, true)) return;
  event(EventKind::zero, s.begin_s,
        "the instrument shows the same again after each turn: its angles are counted on over 360°");
}

}  // namespace axiometry::capture
