// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/target_matcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/numeric/median.h"

namespace axiometry::capture {
namespace {

constexpr std::size_t zero_proof = 3;      // approaches that must follow each other to settle a zero
constexpr std::size_t most_waiting = 200;  // standstills
constexpr int position_decimals = 4;
constexpr double longest_overshoot_mm = 0.05, longest_overshoot_deg = 0.01;
constexpr double overshoot_thresholds = 3.0;

double smallest_interval(const Plan& plan) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < plan.targets.size(); ++i)
    smallest = std::min(smallest, plan.targets[i].in_native() - plan.targets[i - 1].in_native());
  return smallest;
}

std::vector<std::string> remarks_on(const Standstill& s, AxisKind kind) {
  std::vector<std::string> remarks;
  const double scale = deviation_per_position(kind);
  if (s.rejected > 0)
    remarks.push_back(fmt::format("{} of {} samples left out as outliers", s.rejected, s.count + s.rejected));
  if (const double drift = std::abs(s.drift.in_native()); drift > s.threshold.in_native())
    remarks.push_back(fmt::format("drifts by {} {} while at rest", format_fixed(s.drift.in_native() * scale, 2),
                                  deviation_unit(kind)));
  if (s.cut_off) remarks.emplace_back("cut off by missing samples or the end of the recording");
  return remarks;
}

}  // namespace

Position default_window(const Plan& plan) {
  return Position::native(std::min(smallest_interval(plan) / 4, plan.overrun.in_native() / 2));
}

Position came_back_limit(AxisKind kind, Position threshold) {
  return Position::native(std::max(kind == AxisKind::linear ? longest_overshoot_mm : longest_overshoot_deg,
                                   overshoot_thresholds * threshold.in_native()));
}

Result<TargetMatcher> TargetMatcher::make(Plan plan, const MatcherOptions& options) {
  AXIOMETRY_TRY_VOID(check_sound(plan));
  const double window = options.window.value_or(default_window(plan)).in_native();
  const double limit = std::min(smallest_interval(plan) / 2, plan.overrun.in_native());
  if (!(window > 0.0 && window < limit))
    return fail(
        fmt::format("found a window of ±{} around the targets, expected one above 0 and below {}, half way to the "
                    "next target and to the overrun",
                    format_exact(window), format_exact(limit)));
  return TargetMatcher(std::make_shared<const Walk>(std::move(plan)), options);
}

TargetMatcher::Walk::Walk(Plan walked) : plan(std::move(walked)), approaches(axiometry::approaches(plan)) {
  for (const PlannedMove& move : moves(plan))
    if (!move.approach) turning_points.insert(move.to);
  while (first_pass < approaches.size() && approaches[first_pass].direction == approaches[0].direction &&
         (first_pass == 0 || approaches[first_pass].target != approaches[first_pass - 1].target))
    ++first_pass;
}

TargetMatcher::TargetMatcher(std::shared_ptr<const Walk> walk, const MatcherOptions& options)
    : walk_(std::move(walk)),
      options_(options),
      window_(options.window.value_or(default_window(walk_->plan))),
      pace_(walk_->plan),
      warm_up_(walk_->plan.targets.front().in_native() + window_.in_native(),
               walk_->plan.targets.back().in_native() - window_.in_native()) {
  result_.approaches = walk_->approaches.size();
  result_.datum = options.datum;
  result_.window = window_;
}

std::optional<Approach> TargetMatcher::due() const {
  if (complete()) return std::nullopt;
  return walk_->approaches[due_];
}

/// The standstill as the plan counts: sign first, then the place of zero.
Standstill TargetMatcher::in_plan(const Standstill& shown) const {
  const auto placed = [&](Position x) {
    return Position::native(result_.datum.in_native() + (options_.reversed ? -x.in_native() : x.in_native()));
  };
  Standstill s = shown;
  s.position = placed(shown.position);
  s.lowest = placed(options_.reversed ? shown.highest : shown.lowest);
  s.highest = placed(options_.reversed ? shown.lowest : shown.highest);
  for (Position& turn : s.turns) turn = placed(turn);
  if (options_.reversed) {
    s.drift = Position::native(-shown.drift.in_native());
    if (s.arrival) s.arrival = *s.arrival == Direction::up ? Direction::down : Direction::up;
  }
  return s;
}

std::vector<CapturedReading> TargetMatcher::take(const Standstill& standstill) {
  last_time_s_ = standstill.end_s;
  if (options_.zero_at_first_target) return try_zero(standstill);
  std::vector<CapturedReading> readings;
  if (auto reading = match(in_plan(standstill))) readings.push_back(std::move(*reading));
  return readings;
}

std::optional<CapturedReading> TargetMatcher::match(const Standstill& shown_there) {
  if (complete()) {
    note_behind(shown_there);
    return std::nullopt;
  }
  unseen_ = unseen_ || shown_there.after_gap;
  turn_found_ = turn_found_ && !shown_there.after_gap;
  find_turn(shown_there);
  const Standstill s = shifted(shown_there, turns_deg_);
  if (!last_) begin_with(s);
  tell_missing(s);
  lowest_ = std::min(lowest_, s.lowest.in_native());
  highest_ = std::max(highest_, s.highest.in_native());
  if (s.frozen_from_s) {
    event(EventKind::signal_lost, s.begin_s,
          fmt::format("from {} s to {} s the instrument showed {} without a change of the last digit, and then jumped: "
                      "it may have lost its signal; not used",
                      format_fixed(*s.frozen_from_s, 2), format_fixed(s.end_s, 2), shown(s.position)));
    return std::nullopt;
  }
  const auto target = target_at(s.position);
  if (!target && (at_turning_point(s.position) || at_overrun_of_a_turn(s))) {
    ++result_.overruns;
    return std::nullopt;
  }
  const double rest_s = s.end_s - s.begin_s;
  if (rest_s < options_.shortest.in_s()) {
    if (target)
      event(EventKind::too_short, s.begin_s,
            fmt::format("at rest for {} s at target {}, expected at least {} s", format_fixed(rest_s, 2), *target + 1,
                        format_fixed(options_.shortest.in_s(), 2)));
    return std::nullopt;
  }
  const bool before_the_test = !last_ && !s.arrival;
  if (!target && before_the_test) return std::nullopt;
  ++result_.standstills;
  if (!target) {
    event(EventKind::unexpected, s.begin_s,
          fmt::format("at rest at {}, farther than {} from every target", shown(s.position), shown(window_)));
    return std::nullopt;
  }
  const auto placed = approach_for(*target, s);
  const bool again = !placed && begins_again(*target, s);
  if ((placed || again) && came_back(s)) {
    event(
        EventKind::wrong_direction, s.begin_s,
        fmt::format("at target {} the axis was at least {} beyond {} and came back, so that it arrived from the other "
                    "side; not used",
                    *target + 1, shown(s.beyond), shown(s.position)));
    return std::nullopt;
  }
  if (placed && !placed->sure)
    event(EventKind::doubtful, s.begin_s,
          fmt::format("behind the missing samples the time fits none of the approaches to target {}{} left: taken for "
                      "run {}, so that the runs may be others than those of the plan",
                      *target + 1, arrow(*s.arrival), walk_->approaches[placed->approach].run + 1));
  if (placed) return read(placed->approach, s);
  if (again) {
    event(EventKind::restarted, s.begin_s,
          fmt::format("{} came again after {} readings, which were dropped", approach_name(walk_->approaches[0]),
                      result_.readings.size()));
    result_.readings.clear();
    pace_.forget();
    due_ = 0;
    return read(0, s);
  }
  explain(*target, s);
  return std::nullopt;
}

std::optional<std::size_t> TargetMatcher::target_at(Position position) const {
  const auto above = std::ranges::lower_bound(walk_->plan.targets, position);
  for (auto it : {above, above == walk_->plan.targets.begin() ? above : above - 1})
    if (it != walk_->plan.targets.end() && std::abs(it->in_native() - position.in_native()) <= window_.in_native())
      return static_cast<std::size_t>(it - walk_->plan.targets.begin());
  return std::nullopt;
}

bool TargetMatcher::at_turning_point(Position position) const {
  const auto above = walk_->turning_points.lower_bound(Position::native(position.in_native() - window_.in_native()));
  return above != walk_->turning_points.end() && above->in_native() <= position.in_native() + window_.in_native();
}

/// The first approach from the due one on that this standstill can be; behind missing samples the one for which it is
/// time.
std::optional<PlanPace::Placed> TargetMatcher::approach_for(std::size_t target, const Standstill& s) const {
  const bool same_again = last_ && walk_->approaches[*last_].target == target && !was_away() && !unseen_;
  if (!s.arrival || same_again) return std::nullopt;
  const bool gap_behind = last_ && unseen_;
  std::vector<std::size_t> possible;
  for (std::size_t k = due_; k < walk_->approaches.size(); ++k) {
    if (walk_->approaches[k].target != target || walk_->approaches[k].direction != *s.arrival) continue;
    const bool late_begin = !last_ && k < walk_->first_pass;
    if (!gap_behind && (late_begin || passed(due_, k))) return PlanPace::Placed{k};
    if (!gap_behind) return std::nullopt;
    possible.push_back(k);
  }
  return possible.empty() ? std::nullopt : std::optional(pace_.place(possible, s.used_from_s));
}

bool TargetMatcher::came_back(const Standstill& s) const {
  return s.beyond > came_back_limit(walk_->plan.axis.kind, s.threshold);
}

/// Before the first reading: what was done for warm-up.
void TargetMatcher::begin_with(const Standstill& s) {
  for (const Position turn : s.turns) warm_up_.go(turn.in_native());
  warm_up_.go(s.position.in_native());
  result_.full_ways_before = warm_up_.count();
}

void TargetMatcher::tell_missing(const Standstill& s) {
  for (const MissingSamples& missing : s.missing)
    event(EventKind::unseen, missing.from_s,
          fmt::format("samples are missing from {} s to {} s", format_fixed(missing.from_s, 2),
                      format_fixed(missing.to_s, 2)));
}

/// A standstill behind the last approach.
void TargetMatcher::note_behind(const Standstill& shown_there) {
  const Standstill s = shifted(shown_there, turns_deg_);
  if (s.end_s - s.begin_s < options_.shortest.in_s() || !s.arrival || !target_at(s.position)) return;
  if (!(s.highest.in_native() - s.lowest.in_native() > walk_->plan.overrun.in_native() / 2)) return;  // rests on
  if (behind_++ == 0) behind_from_s_ = s.begin_s;
}

/// Whether the axis has been at the targets of all these approaches since the last reading.
bool TargetMatcher::passed(std::size_t first, std::size_t last) const {
  return std::all_of(walk_->approaches.begin() + static_cast<std::ptrdiff_t>(first),
                     walk_->approaches.begin() + static_cast<std::ptrdiff_t>(last), [&](const Approach& a) {
                       const double target = walk_->plan.targets[a.target].in_native();
                       return target >= lowest_ - window_.in_native() && target <= highest_ + window_.in_native();
                     });
}

bool TargetMatcher::was_away() const { return highest_ - lowest_ > walk_->plan.overrun.in_native() / 2; }

CapturedReading TargetMatcher::read(std::size_t approach, const Standstill& s) {
  if (approach > due_) {
    std::string names;
    constexpr std::size_t most_named = 6;
    for (std::size_t k = due_; k < std::min(approach, due_ + most_named); ++k)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", approach_name(walk_->approaches[k]));
    event(EventKind::missed, s.begin_s,
          fmt::format("no standstill for {}{}", names, approach > due_ + most_named ? " and others" : ""));
  }
  const Approach& a = walk_->approaches[approach];
  const double distance = s.position.in_native() - walk_->plan.targets[a.target].in_native();
  CapturedReading reading{a, s, Deviation::native(distance * deviation_per_position(walk_->plan.axis.kind)),
                          remarks_on(s, walk_->plan.axis.kind)};
  result_.readings.push_back(reading);
  pace_.read(approach, s.used_from_s, !unseen_);
  last_ = approach;
  due_ = approach + 1;
  lowest_ = highest_ = s.position.in_native();
  unseen_ = false;
  return reading;
}

void TargetMatcher::explain(std::size_t target, const Standstill& s) {
  const Approach& due = walk_->approaches[due_];
  if (!s.arrival)
    return event(EventKind::unseen, s.begin_s,
                 fmt::format("at rest at {} (target {}), but the way there was not recorded; not used",
                             shown(s.position), target + 1));
  const std::string_view from = arrow(*s.arrival);
  if (last_ && walk_->approaches[*last_].target == target &&
      (!was_away() || walk_->approaches[*last_].direction == *s.arrival))
    return event(EventKind::repeated, s.begin_s,
                 fmt::format("at rest again, at {}; {} keeps its first reading", shown(s.position),
                             approach_name(walk_->approaches[*last_])));
  if (due.target == target)
    return event(EventKind::wrong_direction, s.begin_s,
                 fmt::format("arrived {} at {}, expected {}; not used", from, shown(s.position), approach_name(due)));
  event(EventKind::unexpected, s.begin_s,
        fmt::format("at rest at target {}{} ({}), expected {}; not used", target + 1, from, shown(s.position),
                    approach_name(due)));
}

/// A test that was broken off in its first pass and begun anew.
bool TargetMatcher::begins_again(std::size_t target, const Standstill& s) const {
  return last_ && due_ >= 2 && due_ < walk_->first_pass && target == walk_->approaches[0].target &&
         s.arrival == walk_->approaches[0].direction;
}

std::vector<CapturedReading> TargetMatcher::try_zero(const Standstill& standstill) {
  waiting_.push_back(standstill);
  const std::size_t proof = std::min(zero_proof, walk_->approaches.size());
  for (std::size_t first = 0; first < waiting_.size(); ++first) {
    MatcherOptions options = options_;
    options.zero_at_first_target = false;
    const double shown_there = (options_.reversed ? -1.0 : 1.0) * waiting_[first].position.in_native();
    options.datum = Position::native(walk_->plan.targets[walk_->approaches[0].target].in_native() - shown_there);
    TargetMatcher trial(walk_, options);
    trial.rolls_from_s_ = rolls_from_s_;
    for (std::size_t k = 0; k < first; ++k) trial.begin_with(trial.in_plan(waiting_[k]));
    std::vector<CapturedReading> readings;
    bool fits = true;  // begins with the first approach, and misses none
    for (std::size_t k = first; fits && k < waiting_.size(); ++k) {
      for (CapturedReading& reading : trial.take(waiting_[k])) readings.push_back(std::move(reading));
      fits = !readings.empty() && trial.due_ == readings.size();
    }
    if (!fits || readings.size() < proof) continue;
    trial.event(EventKind::zero, waiting_[first].begin_s,
                fmt::format("the first standstill at target {} showed {}: zero lies at {}",
                            walk_->approaches[0].target + 1, shown(waiting_[first].position), shown(options.datum)));
    *this = std::move(trial);
    return readings;
  }
  if (waiting_.size() > most_waiting) waiting_.erase(waiting_.begin());
  return {};
}

Result<void> TargetMatcher::finish() {
  if (options_.zero_at_first_target)
    return fail(
        fmt::format("found no {} standstills in {} that fit the first approaches of the plan, expected them to set "
                    "the zero",
                    std::min(zero_proof, walk_->approaches.size()), waiting_.size()));
  const std::size_t missing = walk_->approaches.size() - due_;
  if (missing > 0) event(EventKind::incomplete, last_time_s_, ended_before(walk_->approaches[due_], missing - 1));
  if (behind_ > 0)
    event(EventKind::unexpected, behind_from_s_,
          fmt::format("{} at targets behind the last approach of the plan: not used; where a test was broken off and "
                      "begun again, some of its readings are in this one",
                      counted(behind_, "more standstill")));
  std::vector<double> deviations;
  for (const CapturedReading& reading : result_.readings) deviations.push_back(reading.deviation.in_native());
  if (deviations.empty()) return {};
  const double middle = numeric::upper_median(std::move(deviations));
  if (std::abs(middle) > window_.in_native() * deviation_per_position(walk_->plan.axis.kind) / 10)
    event(
        EventKind::off_zero, last_time_s_,
        fmt::format("half of all readings lie beyond {} {}: the zero of the instrument may be another than the plan's",
                    format_fixed(middle, 1), deviation_unit(walk_->plan.axis.kind)));
  return {};
}

void TargetMatcher::event(EventKind kind, double time_s, std::string message) {
  result_.events.push_back({kind, time_s, std::move(message)});
}

std::string TargetMatcher::shown(Position position) const {
  const bool linear = walk_->plan.axis.kind == AxisKind::linear;
  return format_fixed(position.in_native(), position_decimals) + (linear ? " mm" : "°");
}

}  // namespace axiometry::capture
